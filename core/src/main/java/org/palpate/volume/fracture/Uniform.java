package org.palpate.volume.fracture;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * Random numbers that are the same on every JDK. They use {@link SplittableRandom#nextLong}, whose
 * algorithm is specified, plain arithmetic and square roots. One thread.
 */
final class Uniform {
  private static final double UNIT = 0x1p-53;

  private final SplittableRandom random;

  Uniform(long seed) {
    random = new SplittableRandom(seed);
  }

  /** Returns a number from {@code low} to {@code high}. */
  double next(double low, double high) {
    return low + (high - low) * ((random.nextLong() >>> 11) * UNIT);
  }

  /** Returns an integer from 0 to {@code bound}, not included. */
  int nextInt(int bound) {
    return (int) next(0, bound);
  }

  /** Returns a unit vector whose direction is uniformly distributed over the sphere. */
  Vec3 direction() {
    Vec3 v = new Vec3();
    double length;
    do {
      v.set(next(-1, 1), next(-1, 1), next(-1, 1));
      length = v.length();
    } while (length > 1 || length < 0.1);
    return v.mul(1 / length, v);
  }
}
