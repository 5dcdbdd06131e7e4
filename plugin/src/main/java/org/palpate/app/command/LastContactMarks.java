package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ReplayRun;
import org.palpate.io.table.TrajectoryCsvReader;
import org.palpate.proxy.InteractionPoint;
import org.palpate.scene.StandardView;
import org.palpate.scene.TouchMarks;
import org.palpate.scene.WorldAxes;

/** The hand in a picture: a trajectory run to its end, shown at the last frame with contact. */
final class LastContactMarks {
  private static final double TRAIL_STEP_MM = 0.3;

  private final WorldAxes axes;
  private final List<Vec3> trail = new ArrayList<>();
  private List<Vec3> shownTrail = List.of();
  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();
  private boolean contact;

  private LastContactMarks(WorldAxes axes) {
    this.axes = axes;
  }

  /**
   * Runs a trajectory of world mm over a scene.
   *
   * @return what to draw of it; where nothing was touched the last frame
   */
  static TouchMarks of(Path file, ContactScene scene, WorldAxes axes) throws IOException {
    Trajectory trajectory = new Trajectory();
    TrajectoryCsvReader.read(file, true, trajectory::add);
    LastContactMarks marks = new LastContactMarks(axes);
    new ReplayRun(scene, trajectory, true, false).run(marks::take);
    return new TouchMarks(marks.device, marks.point, marks.force, marks.contact, marks.shownTrail);
  }

  private void take(
      int frame,
      Vec3 deviceMm,
      Vec3 pointMm,
      Vec3 forceNewton,
      InteractionPoint state,
      boolean freed) {
    if (!state.contact) {
      trail.clear();
    }
    Vec3 at = axes.swap(pointMm, new Vec3());
    boolean isNew =
        trail.isEmpty()
            || trail.get(trail.size() - 1).sub(at, new Vec3()).length() >= TRAIL_STEP_MM;
    if (state.contact && isNew) {
      trail.add(at);
    }
    if (state.contact || !contact) {
      axes.swap(deviceMm, device);
      point.set(at);
      axes.swap(forceNewton, force);
      contact = state.contact;
      shownTrail = List.copyOf(trail);
    }
  }

  /** The standard view that sees a place most from the front. */
  static StandardView viewOf(Vec3 place, Vec3 middle) {
    Vec3 outward = place.sub(middle, new Vec3());
    StandardView best = StandardView.OBLIQUE;
    for (StandardView view : StandardView.values()) {
      if (view.towardsEye().dot(outward) > best.towardsEye().dot(outward)) {
        best = view;
      }
    }
    return best;
  }
}
