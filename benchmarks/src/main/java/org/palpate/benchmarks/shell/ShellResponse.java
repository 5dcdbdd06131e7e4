package org.palpate.benchmarks.shell;

import java.util.function.Supplier;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * An interaction point for each point of a shell, each with a solver of its own that keeps its
 * caches. Allocates nothing after construction; several threads may move ranges that do not
 * overlap, each with its own view of the collision scene.
 *
 * <p>The points are independent of each other; only the tool that they follow keeps them together.
 */
public final class ShellResponse {
  private final InteractionPoint[] points;
  private final ProxySolver[] solvers;
  private final Vec3[] devices;
  private final NearestFreeVoxel nearestFree;

  /**
   * Creates points that are not yet placed.
   *
   * @param count the number of points of the shell
   * @param metric the grid's spacing
   * @param solver makes a solver
   */
  public ShellResponse(int count, GridMetric metric, Supplier<? extends ProxySolver> solver) {
    points = new InteractionPoint[count];
    solvers = new ProxySolver[count];
    devices = new Vec3[count];
    nearestFree = new NearestFreeVoxel(metric);
    for (int point = 0; point < count; point++) {
      points[point] = new InteractionPoint();
      solvers[point] = solver.get();
      devices[point] = new Vec3();
    }
  }

  /** Returns the interaction point of a point of the shell. */
  public InteractionPoint point(int point) {
    return points[point];
  }

  /**
   * Places every interaction point at its point of the shell, or at the nearest free voxel if that
   * touches a solid. One thread.
   */
  public void place(CollisionScene scene, PointShell shell) {
    for (int point = 0; point < points.length; point++) {
      Vec3 position = shell.now(point, points[point].position);
      points[point].legs.clear();
      points[point].contact = false;
      if (scene.touches(position.x, position.y, position.z)) {
        nearestFree.find(scene, position, position);
      }
      solvers[point].reset();
    }
  }

  /** Resets all solvers, after solids changed. One thread. */
  public void reset() {
    for (ProxySolver solver : solvers) {
      solver.reset();
    }
  }

  /**
   * Lets a range of interaction points follow the shell for one frame.
   *
   * @param from the first point
   * @param to one past the last point
   * @return the number of points with contact
   */
  public int follow(CollisionScene scene, PointShell shell, int from, int to) {
    int contacts = 0;
    for (int point = from; point < to; point++) {
      solvers[point].follow(scene, shell.now(point, devices[point]), points[point]);
      contacts += points[point].contact ? 1 : 0;
    }
    return contacts;
  }
}
