package org.palpate.benchmarks;

import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/** A trajectory that a solver follows, frame by frame. One thread. */
final class TrajectoryFollower {
  private final ProxySolver solver;
  private final CollisionScene obstacles;
  private final Trajectory trajectory;
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  TrajectoryFollower(ProxySolver solver, CollisionScene obstacles, Trajectory trajectory) {
    this.solver = solver;
    this.obstacles = obstacles;
    this.trajectory = trajectory;
  }

  /** Begins, and follows it to its end; the sum of where the point was. */
  double follow() {
    return followFromStart(trajectory.position(0, device));
  }

  /** The same from another place, which touches no solid. */
  double followFromStart(Vec3 start) {
    point.position.set(start);
    solver.reset();
    double sum = 0;
    for (int number = 0; number < trajectory.size(); number++) {
      solver.follow(obstacles, trajectory.position(number, device), point);
      sum += point.position.x;
    }
    return sum;
  }
}
