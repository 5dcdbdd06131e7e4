package org.palpate.device;

import java.util.SplittableRandom;
import org.palpate.geometry.Quaternion;

/**
 * Generates the orientation of a simulated hand from turns and holds, independently of its
 * position. A turn leads to another orientation, by up to about a quarter turn from the identity,
 * in a number of samples; some turns are flicks.
 *
 * <p>The motion has the same bits on every JDK, because it uses only {@code
 * SplittableRandom.nextLong}, whose algorithm is specified, plain arithmetic and square roots. One
 * thread.
 */
final class SimulatedWrist {
  private static final double NANOS_PER_MS = 1e6;

  /**
   * Largest component of an orientation's axis before normalization, with a real component of 1.
   */
  private static final double LARGEST_COMPONENT = 0.6;

  private static final int PERCENT_HOLDS = 30;
  private static final int PERCENT_FLICKS = 8;

  private final SplittableRandom random;
  private final double samplesPerMs;
  private final Quaternion start = new Quaternion();
  private final Quaternion end = new Quaternion();
  private int samples;
  private int sample;

  SimulatedWrist(long seed, long intervalNanos) {
    random = new SplittableRandom(seed);
    samplesPerMs = NANOS_PER_MS / intervalNanos;
  }

  /** Writes the next orientation into {@code dest}, of norm 1. */
  void next(Quaternion dest) {
    if (sample == samples) {
      chooseTurn();
    }
    sample++;
    double t = (double) sample / samples;
    double progress = t * t * t * (10 + t * (6 * t - 15)); // starts and ends without speed
    double rest = 1 - progress;
    dest.set(
        rest * start.w + progress * end.w,
        rest * start.x + progress * end.x,
        rest * start.y + progress * end.y,
        rest * start.z + progress * end.z);
    dest.normalize();
  }

  private void chooseTurn() {
    start.set(end);
    sample = 0;
    int choice = (int) ((random.nextLong() >>> 1) % 100);
    if (choice < PERCENT_HOLDS) {
      samples = samplesFor(50, 300);
      return;
    }
    samples = choice < PERCENT_HOLDS + PERCENT_FLICKS ? samplesFor(10, 40) : samplesFor(250, 1200);
    end.set(1, component(), component(), component());
    end.normalize();
  }

  private double component() {
    return between(-LARGEST_COMPONENT, LARGEST_COMPONENT);
  }

  private int samplesFor(double leastMs, double mostMs) {
    return Math.max(1, (int) (between(leastMs, mostMs) * samplesPerMs));
  }

  private double between(double low, double high) {
    return low + (high - low) * ((random.nextLong() >>> 11) * 0x1p-53);
  }
}
