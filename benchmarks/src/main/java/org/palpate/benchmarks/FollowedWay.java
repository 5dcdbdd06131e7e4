package org.palpate.benchmarks;

import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Obstacles;
import org.palpate.proxy.ProxySolver;

/** A trajectory that a solver follows, frame by frame. One thread. */
final class FollowedWay {
  private final ProxySolver solver;
  private final Obstacles obstacles;
  private final Trajectory trajectory;
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  FollowedWay(ProxySolver solver, Obstacles obstacles, Trajectory trajectory) {
    this.solver = solver;
    this.obstacles = obstacles;
    this.trajectory = trajectory;
  }

  /** Begins, and follows it to its end; the sum of where the point was. */
  double follow() {
    return followFrom(trajectory.at(0, device));
  }

  /** The same from another place, which touches no solid. */
  double followFrom(Vec3 start) {
    point.position.set(start);
    solver.reset();
    double sum = 0;
    for (int number = 0; number < trajectory.frames(); number++) {
      solver.follow(obstacles, trajectory.at(number, device), point);
      sum += point.position.x;
    }
    return sum;
  }
}
