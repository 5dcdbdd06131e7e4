package org.palpate.opencl;

import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;

/**
 * Opens the parts of a batch to benchmarks: one device, voxels of a ball, and points near it. One
 * thread.
 */
public final class OpenClLegsVariants implements AutoCloseable {
  private final OpenClDevice device;
  private final NearBall ball;
  private final OpenClLegs batch;

  /**
   * Opens a device and makes points. Everything is compiled and sent afterwards.
   *
   * @param name a part of the device's name
   */
  public OpenClLegsVariants(String name, int points) throws OpenClException {
    device = OpenClDevice.open(name);
    ball = new NearBall(points);
    batch = device.newBatch(ball.voxels(), ball);
    batch.judge(ball.from(), ball.to(), OpenClDevice.FIRST_DEADLINE_NANOS);
  }

  /** Returns a batch on the CPU with the same voxels, points and motion. */
  public static LegBatch onCpu(int points) {
    NearBall ball = new NearBall(points);
    LegBatch batch = CollisionDevice.CPU.keep(ball.voxels()).newBatch(ball);
    batch.judge(ball.from(), ball.to());
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
    batch.launch(ball.from(), ball.to());
    batch.fetch(1, deadline());
  }

  /** Fetches all verdicts, without judging anew. */
  public void transfer() {
    batch.fetch(ball.count(), deadline());
  }

  /** Does all that a motion needs. */
  public void whole() {
    batch.judge(ball.from(), ball.to(), OpenClDevice.FIRST_DEADLINE_NANOS);
  }

  @Override
  public void close() {
    device.close();
  }
}
