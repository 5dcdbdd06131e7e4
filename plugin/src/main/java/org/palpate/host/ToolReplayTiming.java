package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolMotion;

/**
 * Measures the time of solver, force and torque of a rigid tool over a trajectory, with nothing
 * else inside. One thread.
 */
public final class ToolReplayTiming {
  private final RigidSolver solver;
  private final RigidCoupling coupling;
  private final List<Pose> devices;
  private final ToolMotion motion = new ToolMotion();
  private final Vec3 forceNewton = new Vec3();
  private final Vec3 torqueNewtonMm = new Vec3();

  /** Prepares a timing over the valid samples of a trajectory in world mm. */
  public ToolReplayTiming(ToolScene scene, Trajectory trajectory) {
    solver = scene.solver();
    coupling = scene.coupling(scene.contactScene().defaultStiffnessNewtonPerMm());
    devices = poses(trajectory);
  }

  private static List<Pose> poses(Trajectory trajectory) {
    List<Pose> poses = new ArrayList<>();
    DeviceState state = new DeviceState();
    for (int n = 0; n < trajectory.size(); n++) {
      trajectory.read(n, state);
      if (state.positionMm.isFinite() && state.orientation.isNearUnit()) {
        poses.add(new Pose().set(state.positionMm, state.orientation));
      }
    }
    return poses;
  }

  /**
   * Runs all passes.
   *
   * @param passes number of passes, more than {@link ReplayTiming#UNCOUNTED_PASSES}
   */
  public ReplayTiming.NanosPerFrame run(int passes) {
    return ReplayTiming.measure(
        passes, devices.size(), () -> solver.place(devices.get(0), motion), this::pass);
  }

  private void pass() {
    for (int n = 0; n < devices.size(); n++) {
      solver.follow(devices.get(n), motion);
      coupling.compute(motion.pose(), solver.target(), forceNewton, torqueNewtonMm);
    }
  }
}
