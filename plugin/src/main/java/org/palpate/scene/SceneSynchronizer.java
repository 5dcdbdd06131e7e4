package org.palpate.scene;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.geometry.Vec3;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.VoxelGrid;

/**
 * One tick of the synchronization: takes what the frames published, as one, and applies it to the
 * scene, each property once; a tick with nothing new changes nothing. The one reader of the
 * properties; one thread.
 */
public final class SceneSynchronizer implements Runnable {
  /** Places of the trail that are kept. */
  private static final int TRAIL = 90;

  /** Places nearer than this share of the scene's radius to the last are left out. */
  private static final double TRAIL_STEP = 0.004;

  private final TouchProperties properties;
  private final VoxelGrid grid;
  private final SceneModel model;
  private final Supplier<List<String>> overlay;
  private final Deque<Vec3> trail = new ArrayDeque<>();
  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();
  private long applications;

  /**
   * A reader of properties in grid coordinates.
   *
   * @param overlay lines for the corner, asked for at each tick; equal lines cause no redraw
   */
  public SceneSynchronizer(
      TouchProperties properties,
      VoxelGrid grid,
      SceneModel model,
      Supplier<List<String>> overlay) {
    this.properties = properties;
    this.grid = grid;
    this.model = model;
    this.overlay = overlay;
  }

  @Override
  public void run() {
    if (properties.accumulator().take()) {
      apply();
    }
    model.setOverlay(overlay.get());
  }

  private void apply() {
    toScene(properties.touch().device(device), device);
    toScene(properties.touch().interactionPoint(point), point);
    properties.touch().force(force);
    grid.gridMmToWorld().rotate(force, force);
    model.axes().swap(force, force);
    boolean contact = properties.touch().contact();
    extendTrail(contact);
    TouchMarks marks =
        new TouchMarks(
            new Vec3().set(device),
            new Vec3().set(point),
            new Vec3().set(force),
            contact,
            new ArrayList<>(trail));
    model.setMarks(Optional.of(marks));
    properties
        .accumulator()
        .properties()
        .forEach(
            property -> {
              if (property.isDirty()) {
                property.markApplied();
              }
            });
    applications++;
  }

  private void toScene(Vec3 inGrid, Vec3 dest) {
    model.axes().swap(grid.gridToWorld(inGrid, dest), dest);
  }

  private void extendTrail(boolean contact) {
    if (!contact) {
      trail.clear();
      return;
    }
    Vec3 last = trail.peekLast();
    double step = TRAIL_STEP * model.state().radiusMm();
    if (last == null || last.sub(point, new Vec3()).length() > step) {
      trail.addLast(new Vec3().set(point));
    }
    if (trail.size() > TRAIL) {
      trail.removeFirst();
    }
  }

  /** Ticks that had something new to apply. */
  public long applications() {
    return applications;
  }
}
