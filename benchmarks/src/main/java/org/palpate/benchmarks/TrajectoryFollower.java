package org.palpate.benchmarks;

import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;

/** Lets a solver follow a trajectory frame by frame. One thread. */
final class TrajectoryFollower {
  private final ProxySolver solver;
  private final CollisionScene scene;
  private final Trajectory trajectory;
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  /** Creates a follower of one trajectory. */
  TrajectoryFollower(ProxySolver solver, CollisionScene scene, Trajectory trajectory) {
    this.solver = solver;
    this.scene = scene;
    this.trajectory = trajectory;
  }

  /** Follows the trajectory from its first position; returns a sum that depends on every frame. */
  double follow() {
    return followFromStart(trajectory.position(0, device));
  }

  /** Follows the trajectory from another position, which must not touch a solid. */
  double followFromStart(Vec3 start) {
    point.position.set(start);
    solver.reset();
    double sum = 0;
    for (int number = 0; number < trajectory.size(); number++) {
      solver.follow(scene, trajectory.position(number, device), point);
      sum += point.position.x;
    }
    return sum;
  }
}
