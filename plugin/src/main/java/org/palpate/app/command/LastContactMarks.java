package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ReplayRun;
import org.palpate.host.ToolReplay;
import org.palpate.host.ToolScene;
import org.palpate.host.TrajectoryFile;
import org.palpate.proxy.InteractionPoint;
import org.palpate.rigid.ToolMotion;
import org.palpate.scene.StandardView;
import org.palpate.scene.ToolMarks;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;

/**
 * Collects the marks for a picture: runs a trajectory to its end and keeps the last frame with
 * contact.
 */
final class LastContactMarks {
  private static final double TRAIL_STEP_MM = 0.3;

  private final WorldAxes axes;
  private final List<Vec3> trail = new ArrayList<>();
  private List<Vec3> shownTrail = List.of();
  private final Vec3 shownDevice = new Vec3();
  private final Vec3 shownPoint = new Vec3();
  private final Vec3 shownForce = new Vec3();
  private boolean hasContact;

  private LastContactMarks(WorldAxes axes) {
    this.axes = axes;
  }

  /**
   * Runs a trajectory in world mm over a scene.
   *
   * @return the marks of the last frame with contact; of the last frame if there was no contact
   */
  static TouchMarks of(Path file, ContactScene scene, WorldAxes axes) throws IOException {
    Trajectory trajectory = TrajectoryFile.read(file, true);
    LastContactMarks marks = new LastContactMarks(axes);
    ReplayRun.inWorld(scene, trajectory).run(marks::take);
    return new TouchMarks(
        marks.shownDevice, marks.shownPoint, marks.shownForce, marks.hasContact, marks.shownTrail);
  }

  /** Runs a trajectory of a rigid tool over a scene; returns marks as the other method does. */
  static TouchMarks ofTool(Path file, ToolScene scene, WorldAxes axes) throws IOException {
    Trajectory trajectory = TrajectoryFile.read(file, true);
    LastContactMarks marks = new LastContactMarks(axes);
    Pose shownPose = new Pose();
    Vec3 shownTorque = new Vec3();
    List<Vec3> shownContacts = new ArrayList<>();
    new ToolReplay(scene, trajectory, false)
        .run(
            (number, frame) -> {
              ToolMotion motion = frame.motion();
              Pose pose = motion.pose();
              boolean contact = motion.contact();
              if (contact || !marks.hasContact) {
                shownPose.set(pose);
                shownTorque.set(frame.torqueNewtonMm());
                shownContacts.clear();
                for (int n = 0; n < motion.contacts().count(); n++) {
                  shownContacts.add(motion.contactMm(n, new Vec3()));
                }
              }
              marks.take(frame.sample().positionMm, pose.translation, frame.forceNewton(), contact);
            });
    RigidTransform toolToWorld = shownPose.transform(RigidTransform.identity());
    ToolMarks tool =
        ToolMarks.at(scene.drawnPoints(), toolToWorld, shownContacts, shownTorque, axes);
    return new TouchMarks(
        marks.shownDevice,
        marks.shownPoint,
        marks.shownForce,
        marks.hasContact,
        marks.shownTrail,
        Optional.of(tool));
  }

  private void take(
      int frame,
      Vec3 deviceMm,
      Vec3 pointMm,
      Vec3 forceNewton,
      InteractionPoint state,
      boolean freed) {
    take(deviceMm, pointMm, forceNewton, state.contact);
  }

  private void take(Vec3 deviceMm, Vec3 pointMm, Vec3 forceNewton, boolean contact) {
    if (!contact) {
      trail.clear();
    }
    Vec3 at = axes.toSceneOrBack(pointMm, new Vec3());
    boolean isNew =
        trail.isEmpty()
            || trail.get(trail.size() - 1).sub(at, new Vec3()).length() >= TRAIL_STEP_MM;
    if (contact && isNew) {
      trail.add(at);
    }
    if (contact || !hasContact) {
      axes.toSceneOrBack(deviceMm, shownDevice);
      shownPoint.set(at);
      axes.toSceneOrBack(forceNewton, shownForce);
      hasContact = contact;
      shownTrail = List.copyOf(trail);
    }
  }

  /**
   * Returns the standard view that faces a position best.
   *
   * @param position a point of the surface
   * @param middle the middle of the scene
   */
  static StandardView viewOf(Vec3 position, Vec3 middle) {
    Vec3 outward = position.sub(middle, new Vec3());
    StandardView best = StandardView.OBLIQUE;
    for (StandardView view : StandardView.values()) {
      if (view.towardsEye().dot(outward) > best.towardsEye().dot(outward)) {
        best = view;
      }
    }
    return best;
  }
}
