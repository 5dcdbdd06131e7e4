package org.palpate.benchmarks.shell;

import java.util.function.Supplier;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/**
 * An interaction point for each point of a shell, with a solver of its own that remembers what it
 * learned about its surroundings. Allocates nothing after construction; ranges that do not overlap
 * may be moved by several threads, each with its own view of the obstacles.
 *
 * <p>The points do not know of each other: what keeps them together is the tool that they follow.
 */
public final class ShellResponse {
  private final InteractionPoint[] points;
  private final ProxySolver[] solvers;
  private final Vec3[] devices;
  private final NearestFreeVoxel freePlace;

  /**
   * Points that are not placed yet.
   *
   * @param count as the shell has
   * @param metric the grid's spacing
   * @param solver makes a solver
   */
  public ShellResponse(int count, GridMetric metric, Supplier<? extends ProxySolver> solver) {
    points = new InteractionPoint[count];
    solvers = new ProxySolver[count];
    devices = new Vec3[count];
    freePlace = new NearestFreeVoxel(metric);
    for (int point = 0; point < count; point++) {
      points[point] = new InteractionPoint();
      solvers[point] = solver.get();
      devices[point] = new Vec3();
    }
  }

  /** The interaction point of a point of the shell. */
  public InteractionPoint point(int point) {
    return points[point];
  }

  /**
   * Puts every interaction point where its point of the shell is, or at the nearest empty place
   * where that touches a solid. One thread.
   */
  public void place(CollisionScene obstacles, PointShell shell) {
    for (int point = 0; point < points.length; point++) {
      Vec3 position = shell.now(point, points[point].position);
      points[point].legs.clear();
      points[point].contact = false;
      if (obstacles.touches(position.x, position.y, position.z)) {
        freePlace.find(obstacles, position, position);
      }
      solvers[point].reset();
    }
  }

  /** Forgets what is kept from frame to frame, after solids changed. One thread. */
  public void reset() {
    for (ProxySolver solver : solvers) {
      solver.reset();
    }
  }

  /**
   * Moves a range of interaction points after the shell, one frame.
   *
   * @param from the first point
   * @param to one past the last
   * @return how many have contact
   */
  public int follow(CollisionScene obstacles, PointShell shell, int from, int to) {
    int contacts = 0;
    for (int point = from; point < to; point++) {
      solvers[point].follow(obstacles, shell.now(point, devices[point]), points[point]);
      contacts += points[point].contact ? 1 : 0;
    }
    return contacts;
  }
}
