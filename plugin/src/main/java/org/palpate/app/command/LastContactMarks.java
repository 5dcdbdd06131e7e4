package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.device.Trajectory;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.PublishedShape;
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
import org.palpate.scene.Deformation;
import org.palpate.scene.SceneModel;
import org.palpate.scene.StandardView;
import org.palpate.scene.ToolMarks;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;
import org.palpate.sync.Accumulator;
import org.palpate.volume.VoxelGrid;

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

  /** The shape of elastic segments after each frame; empty if there are none. */
  private Optional<PublishedShape> shape = Optional.empty();

  private final Accumulator frames = new Accumulator();
  private Optional<Deformation> shownDeformation = Optional.empty();

  private LastContactMarks(WorldAxes axes) {
    this.axes = axes;
  }

  /**
   * Runs a trajectory in world mm over a scene, and shows the last frame with contact in a model;
   * the last frame if there was no contact.
   *
   * @param elastic makes the elastic segments at rest, if there are any
   */
  static void show(
      Path file, ContactScene scene, Optional<Supplier<ElasticBody>> elastic, SceneModel model)
      throws IOException {
    Trajectory trajectory = TrajectoryFile.read(file, true);
    LastContactMarks marks = new LastContactMarks(model.axes());
    ReplayRun rigid = ReplayRun.inWorld(scene, trajectory);
    elastic
        .map(bodies -> rigid.withElastic(() -> marks.published(bodies.get())))
        .orElse(rigid)
        .run(
            (frame, device, point, force, state, freed) ->
                marks.take(device, point, force, state, scene.grid()));
    model.setMarks(
        Optional.of(
            new TouchMarks(
                marks.shownDevice,
                marks.shownPoint,
                marks.shownForce,
                marks.hasContact,
                marks.shownTrail)),
        marks.shownDeformation);
  }

  private ElasticBody published(ElasticBody body) {
    shape = Optional.of(body.publish(frames));
    return body;
  }

  /** Runs a trajectory of a rigid tool over a scene, and shows it as the other method does. */
  static void showTool(Path file, ToolScene scene, SceneModel model) throws IOException {
    Trajectory trajectory = TrajectoryFile.read(file, true);
    LastContactMarks marks = new LastContactMarks(model.axes());
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
        ToolMarks.at(scene.drawnPoints(), toolToWorld, shownContacts, shownTorque, model.axes());
    model.setMarks(
        Optional.of(
            new TouchMarks(
                marks.shownDevice,
                marks.shownPoint,
                marks.shownForce,
                marks.hasContact,
                marks.shownTrail,
                Optional.of(tool))));
  }

  /** Takes a frame of a point. Its trail is kept at rest and shown as it is deformed. */
  private void take(
      Vec3 deviceMm, Vec3 pointMm, Vec3 forceNewton, InteractionPoint state, VoxelGrid grid) {
    Vec3 atRestMm = grid.gridToWorld(state.position, new Vec3());
    boolean isShown = take(deviceMm, pointMm, atRestMm, forceNewton, state.contact);
    if (isShown && shape.isPresent()) {
      shape.get().setFrame();
      frames.publish();
      frames.take();
      shape.get().take();
      shownDeformation = Optional.of(Deformation.of(shape.get()));
      shownTrail = shownTrail.stream().map(point -> present(point, grid)).toList();
    }
  }

  private Vec3 present(Vec3 atRest, VoxelGrid grid) {
    Vec3 at = grid.worldToGrid(axes.toSceneOrBack(atRest, new Vec3()), new Vec3());
    shape.orElseThrow().present(at, at);
    grid.gridToWorld(at, at);
    return axes.toSceneOrBack(at, at);
  }

  private void take(Vec3 deviceMm, Vec3 pointMm, Vec3 forceNewton, boolean contact) {
    take(deviceMm, pointMm, pointMm, forceNewton, contact);
  }

  /** Takes a frame; returns whether it is shown unless a later one is. */
  private boolean take(
      Vec3 deviceMm, Vec3 pointMm, Vec3 trailMm, Vec3 forceNewton, boolean contact) {
    if (!contact) {
      trail.clear();
    }
    Vec3 at = axes.toSceneOrBack(trailMm, new Vec3());
    boolean isNew =
        trail.isEmpty()
            || trail.get(trail.size() - 1).sub(at, new Vec3()).length() >= TRAIL_STEP_MM;
    if (contact && isNew) {
      trail.add(at);
    }
    boolean isShown = contact || !hasContact;
    if (isShown) {
      axes.toSceneOrBack(deviceMm, shownDevice);
      axes.toSceneOrBack(pointMm, shownPoint);
      axes.toSceneOrBack(forceNewton, shownForce);
      hasContact = contact;
      shownTrail = List.copyOf(trail);
    }
    return isShown;
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
