package org.palpate.host;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.DeviceState;
import org.palpate.device.Trajectory;
import org.palpate.force.ContactForce;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.TouchedObjectFinder;

/**
 * Measures the time of solver and force over a trajectory, with nothing else inside. One thread.
 */
public final class ReplayTiming {
  /** Passes that are run first and not counted, because they run interpreted code. */
  public static final int UNCOUNTED_PASSES = 2;

  private final CollisionScene collisionScene;
  private final ProxySolver solver;
  private final ContactForce contactForce;
  private final TouchedObjectFinder touched = new TouchedObjectFinder();
  private final NearestFreeVoxel nearestFree;
  private final Vec3[] devices;
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 forceNewton = new Vec3();

  /**
   * Prepares a timing over the valid samples of a trajectory.
   *
   * @param scene the segments and their contact settings
   * @param trajectory the samples
   * @param world whether the trajectory is in world mm; otherwise in grid coordinates
   */
  public ReplayTiming(ContactScene scene, Trajectory trajectory, boolean world) {
    collisionScene = scene.newCollisionScene();
    solver = scene.newSolver();
    contactForce =
        new ContactForce(scene.metric(), scene.force(scene.defaultStiffnessNewtonPerMm()));
    nearestFree = new NearestFreeVoxel(scene.metric());
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
   * Time of one frame in nanoseconds, over the passes that count.
   *
   * @param min the fastest pass
   * @param median the median of the passes
   * @param max the slowest pass
   */
  public record NanosPerFrame(double min, double median, double max) {}

  /**
   * Runs all passes.
   *
   * @param passes number of passes, more than {@link #UNCOUNTED_PASSES}
   * @return the time of a frame over the counted passes
   */
  public NanosPerFrame run(int passes) {
    return measure(passes, devices.length, this::placeAtFirstSample, this::pass);
  }

  /**
   * Measures passes.
   *
   * @param begin runs before each pass, and is not measured
   */
  static NanosPerFrame measure(int passes, int frames, Runnable begin, Runnable pass) {
    double[] nanos = new double[passes];
    for (int n = 0; n < passes; n++) {
      begin.run();
      long startNanos = System.nanoTime();
      pass.run();
      nanos[n] = (double) (System.nanoTime() - startNanos) / frames;
    }
    double[] counted = Arrays.copyOfRange(nanos, UNCOUNTED_PASSES, passes);
    Arrays.sort(counted);
    return new NanosPerFrame(counted[0], Median.of(counted), counted[counted.length - 1]);
  }

  private void placeAtFirstSample() {
    Vec3 p = point.position.set(devices[0]);
    solver.reset();
    if (collisionScene.touches(p.x, p.y, p.z)) {
      nearestFree.find(collisionScene, p, p);
    }
  }

  private void pass() {
    for (Vec3 device : devices) {
      solver.follow(collisionScene, device, point);
      if (contactForce.settings().distinguishesObjects()) {
        touched.find(collisionScene, device, point);
      }
      contactForce.compute(point, device, TrajectoryDevice.FRAME_NANOS, forceNewton);
    }
  }
}
