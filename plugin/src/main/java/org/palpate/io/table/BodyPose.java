package org.palpate.io.table;

import org.palpate.body.BodyEvent;
import org.palpate.geometry.Pose;

/**
 * A pose of a body in a table.
 *
 * @param frame number of the frame, from 0
 * @param body index of the body in its scene
 * @param event how a recorded session brought the body there; {@link BodyEvent#MOVED} for a pose
 *     that it approaches from the frame on
 * @param restToPresent the pose, world mm, with a quaternion of norm 1
 * @param inHand the pose of the body's reference point relative to the device; of no meaning unless
 *     the event is {@link BodyEvent#TAKEN}
 */
public record BodyPose(long frame, int body, BodyEvent event, Pose restToPresent, Pose inHand) {}
