package org.palpate.opencl;

import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;

/**
 * Opens the parts of a batch to benchmarks: one device, voxels of a ball, and points near it. One
 * thread.
 */
public final class OpenClLegsVariants implements AutoCloseable {
  private final OpenClDevice device;
  private final int points;
  private final OpenClLegs batch;
  private final MotionGroup one;
  private final MotionGroup several;

  /** Verdicts are summed so that no reading can be left out. */
  private long notFree;

  /**
   * Opens a device and makes points. Everything is compiled and sent afterwards.
   *
   * @param name a part of the device's name
   */
  public OpenClLegsVariants(String name, int points) throws OpenClException {
    this.points = points;
    device = OpenClDevice.open(name);
    NearBall ball = new NearBall(points);
    batch = device.newBatch(ball.voxels(), ball);
    one = ball.motions(1);
    several = ball.motions(MotionGroup.CAPACITY);
    whole();
    wholeOfSeveral();
  }

  /** Returns a batch on the CPU with the same voxels, points and motion. */
  public static LegBatch onCpu(int points) {
    NearBall ball = new NearBall(points);
    LegBatch batch = CollisionDevice.CPU.keep(ball.voxels()).newBatch(ball);
    batch.judge(ball.motions(1));
    return batch;
  }

  private static long deadline() {
    return System.nanoTime() + OpenClDevice.FIRST_DEADLINE_NANOS;
  }

  /** Fetches one byte: the least time of any answer. */
  public void roundTrip() {
    batch.fetch(1, deadline());
  }

  /** Sends the maps, judges, and fetches one byte. */
  public void launch() {
    batch.launch(one);
    batch.fetch(1, deadline());
  }

  /** Fetches all verdicts, without judging anew. */
  public void transfer() {
    batch.fetch(points, deadline());
  }

  /** Reads the verdicts of the last motion on the host, one after the other. */
  public void read() {
    read(0);
  }

  private void read(int motion) {
    for (int n = 0; n < points; n++) {
      notFree += batch.verdict(motion, n) == LegVerdict.FREE ? 0 : 1;
    }
  }

  /** Does all that a motion needs. */
  public void whole() {
    batch.judge(one, OpenClDevice.FIRST_DEADLINE_NANOS);
    read(0);
  }

  /** Does all that {@link MotionGroup#CAPACITY} motions need, in one launch. */
  public void wholeOfSeveral() {
    batch.judge(several, OpenClDevice.FIRST_DEADLINE_NANOS);
    for (int motion = 0; motion < several.count(); motion++) {
      read(motion);
    }
  }

  /** Returns how many legs were not free in all readings. */
  public long notFree() {
    return notFree;
  }

  @Override
  public void close() {
    device.close();
  }
}
