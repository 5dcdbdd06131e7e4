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
 * Applies what the frames published to the scene, one tick at a time. Each changed property is
 * applied once; a tick without changes does nothing.
 *
 * <p>The one reader of the properties; one thread.
 */
public final class SceneSynchronizer implements Runnable {
  /** Number of points of the trail that are kept. */
  private static final int MAX_TRAIL_POINTS = 90;

  /** Least distance between two points of the trail, relative to the scene's radius. */
  private static final double TRAIL_STEP = 0.004;

  private final TouchProperties properties;
  private final VoxelGrid grid;
  private final SceneModel model;
  private final Supplier<List<String>> overlay;
  private final Supplier<Optional<ToolMarks>> tool;
  private final Deque<Vec3> trail = new ArrayDeque<>();
  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();
  private long applications;

  /**
   * Creates a reader of properties in grid coordinates.
   *
   * @param overlay provides the overlay's lines at each tick; equal lines cause no redraw
   */
  public SceneSynchronizer(
      TouchProperties properties,
      VoxelGrid grid,
      SceneModel model,
      Supplier<List<String>> overlay) {
    this(properties, grid, model, overlay, Optional::empty);
  }

  /**
   * Creates a reader that also shows a rigid tool.
   *
   * @param tool provides the marks of the tool as of the last publication that was taken
   */
  public SceneSynchronizer(
      TouchProperties properties,
      VoxelGrid grid,
      SceneModel model,
      Supplier<List<String>> overlay,
      Supplier<Optional<ToolMarks>> tool) {
    this.tool = tool;
    this.properties = properties;
    this.grid = grid;
    this.model = model;
    this.overlay = overlay;
  }

  /** Runs one tick. */
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
    model.axes().toSceneOrBack(force, force);
    boolean contact = properties.touch().contact();
    extendTrail(contact);
    TouchMarks marks =
        new TouchMarks(
            new Vec3().set(device),
            new Vec3().set(point),
            new Vec3().set(force),
            contact,
            new ArrayList<>(trail),
            tool.get());
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

  private void toScene(Vec3 gridPoint, Vec3 dest) {
    model.axes().toSceneOrBack(grid.gridToWorld(gridPoint, dest), dest);
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
    if (trail.size() > MAX_TRAIL_POINTS) {
      trail.removeFirst();
    }
  }

  /** Returns the number of ticks that applied a change. */
  public long applications() {
    return applications;
  }
}
