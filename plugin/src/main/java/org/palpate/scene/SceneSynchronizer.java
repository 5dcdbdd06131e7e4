package org.palpate.scene;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.palpate.elastic.PublishedShape;
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
  private final Optional<PublishedShape> shape;

  /** The last points of the contact: material coordinates if segments are elastic, else grid. */
  private final Deque<Vec3> trail = new ArrayDeque<>();

  private final Vec3 device = new Vec3();
  private final Vec3 point = new Vec3();
  private final Vec3 force = new Vec3();
  private final Vec3 scratch = new Vec3();
  private Optional<Deformation> deformation = Optional.empty();
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
    this(properties, grid, model, overlay, Optional::empty, Optional.empty());
  }

  /**
   * Creates a reader that also shows a rigid tool or elastic segments.
   *
   * @param tool provides the marks of the tool as of the last publication that was taken
   * @param shape the shape of elastic segments, published in these properties, if there are any
   */
  public SceneSynchronizer(
      TouchProperties properties,
      VoxelGrid grid,
      SceneModel model,
      Supplier<List<String>> overlay,
      Supplier<Optional<ToolMarks>> tool,
      Optional<PublishedShape> shape) {
    this.tool = tool;
    this.shape = shape;
    this.properties = properties;
    this.grid = grid;
    this.model = model;
    this.overlay = overlay;
  }

  /** Runs one tick. */
  @Override
  public void run() {
    boolean changed = properties.accumulator().take();
    if (shape.isPresent() && shape.get().take()) {
      deformation = Optional.of(Deformation.of(shape.get()));
      changed = true;
    }
    if (changed) {
      apply();
    }
    model.setOverlay(overlay.get());
  }

  private void apply() {
    toScene(properties.touch().device(device), device);
    pointAtRest(point);
    properties.touch().force(force);
    grid.gridMmToWorld().rotate(force, force);
    model.axes().toSceneOrBack(force, force);
    boolean contact = properties.touch().contact();
    extendTrail(contact);
    TouchMarks marks =
        new TouchMarks(
            new Vec3().set(device),
            presentInScene(point),
            new Vec3().set(force),
            contact,
            trail.stream().map(this::presentInScene).toList(),
            tool.get());
    model.setMarks(Optional.of(marks), deformation);
    properties.markApplied();
    applications++;
  }

  private void toScene(Vec3 gridPoint, Vec3 dest) {
    model.axes().toSceneOrBack(grid.gridToWorld(gridPoint, dest), dest);
  }

  /**
   * Writes the interaction point that was taken last among the voxels at rest: in material
   * coordinates if segments are elastic, else in grid coordinates.
   */
  public Vec3 pointAtRest(Vec3 dest) {
    return shape.isPresent()
        ? shape.get().materialPoint(dest)
        : properties.touch().interactionPoint(dest);
  }

  /**
   * Writes the device position that was taken last, as far from {@link #pointAtRest} as the device
   * is from the interaction point.
   */
  public Vec3 deviceAtRest(Vec3 dest) {
    properties.touch().device(dest);
    if (shape.isPresent()) {
      dest.sub(properties.touch().interactionPoint(scratch), dest);
      dest.add(pointAtRest(scratch), dest);
    }
    return dest;
  }

  /** Returns where a point of the grid is in the scene, after the deformation. */
  private Vec3 presentInScene(Vec3 gridPoint) {
    Vec3 present = new Vec3().set(gridPoint);
    shape.ifPresent(deformed -> deformed.present(present, present));
    toScene(present, present);
    return present;
  }

  private void extendTrail(boolean contact) {
    if (!contact) {
      trail.clear();
      return;
    }
    Vec3 last = trail.peekLast();
    double step = TRAIL_STEP * model.state().radiusMm();
    if (last == null || distanceMm(last, point) > step) {
      trail.addLast(new Vec3().set(point));
    }
    if (trail.size() > MAX_TRAIL_POINTS) {
      trail.removeFirst();
    }
  }

  private double distanceMm(Vec3 a, Vec3 b) {
    return grid.metric().distance(a.x, a.y, a.z, b.x, b.y, b.z);
  }

  /** Returns the number of ticks that applied a change. */
  public long applications() {
    return applications;
  }
}
