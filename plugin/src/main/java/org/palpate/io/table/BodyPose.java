package org.palpate.io.table;

import org.palpate.geometry.Pose;

/**
 * A pose that a body approaches from a frame on.
 *
 * @param frame number of the frame, from 0
 * @param body index of the body in its scene
 * @param restToPresent the pose, world mm, with a quaternion of norm 1
 */
public record BodyPose(long frame, int body, Pose restToPresent) {}
