package org.palpate.host;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.TouchedObjectFinder;

/** The time of solver and force over a trajectory, nothing else inside. One thread. */
public final class ReplayTiming {
  /** Passes that are run first and not counted: they find interpreted code. */
  public static final int UNCOUNTED_PASSES = 2;

  private final CollisionScene obstacles;
  private final ProxySolver solver;
  private final ContactForce contactForce;
  private final TouchedObjectFinder touched = new TouchedObjectFinder();
  private final NearestFreeVoxel freePlace;
  private final Vec3[] devices;
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 forceNewton = new Vec3();

  /**
   * A timing over the samples of a trajectory that are positions.
   *
   * @param world whether it is in world mm; grid coordinates else
   */
  public ReplayTiming(ContactScene scene, Trajectory trajectory, boolean world) {
    obstacles = scene.newObstacles();
    solver = scene.newSolver();
    contactForce =
        new ContactForce(
            scene.metric(), scene.force(ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM));
    freePlace = new NearestFreeVoxel(scene.metric());
    devices = positions(scene, trajectory, world);
  }

  private static Vec3[] positions(ContactScene scene, Trajectory trajectory, boolean world) {
    Vec3[] positions = new Vec3[trajectory.size()];
    DeviceState state = new DeviceState();
    int count = 0;
    for (int n = 0; n < positions.length; n++) {
      trajectory.read(n, state);
      if (state.positionMm.isFinite()) {
        Vec3 position = new Vec3().set(state.positionMm);
        positions[count++] = world ? scene.grid().worldToGrid(position, position) : position;
      }
    }
    return Arrays.copyOf(positions, count);
  }

  /**
   * Nanoseconds a frame.
   *
   * @param min of the passes that count
   * @param median of the passes that count
   * @param max of the passes that count
   */
  public record NanosPerFrame(double min, double median, double max) {}

  /**
   * Runs all passes.
   *
   * @param passes more than {@link #UNCOUNTED_PASSES}
   */
  public NanosPerFrame run(int passes) {
    double[] nanos = new double[passes];
    for (int pass = 0; pass < passes; pass++) {
      start();
      long began = System.nanoTime();
      pass();
      nanos[pass] = (double) (System.nanoTime() - began) / devices.length;
    }
    double[] counted = Arrays.copyOfRange(nanos, UNCOUNTED_PASSES, passes);
    Arrays.sort(counted);
    return new NanosPerFrame(counted[0], Median.of(counted), counted[counted.length - 1]);
  }

  private void start() {
    Vec3 p = point.position.set(devices[0]);
    solver.reset();
    if (obstacles.touches(p.x, p.y, p.z)) {
      freePlace.find(obstacles, p, p);
    }
  }

  private void pass() {
    for (Vec3 device : devices) {
      solver.follow(obstacles, device, point);
      if (contactForce.settings().distinguishesObjects()) {
        touched.find(obstacles, device, point);
      }
      contactForce.compute(point, device, TrajectoryDevice.FRAME_NANOS, forceNewton);
    }
  }
}
