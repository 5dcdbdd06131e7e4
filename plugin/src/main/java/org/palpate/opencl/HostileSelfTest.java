package org.palpate.opencl;

import java.util.SplittableRandom;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.MotionGroup;
import org.palpate.volume.BitCube;

/**
 * Compares the verdicts of a device with those of the CPU before it is used: legs that graze edges
 * and corners of voxels, where a fused or inexact operation would show.
 */
final class HostileSelfTest {
  private static final int SIZE = 32;
  private static final int SETS = 3;
  private static final int POINTS = 8_192;
  private static final long SEED = 1;

  private HostileSelfTest() {}

  /**
   * Compares the verdicts.
   *
   * @param firstNanos the time within which a batch must be judged
   * @throws IllegalStateException if a verdict is wrong
   */
  static void requireExact(OpenClDevice device, long firstNanos) {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int set = 0; set < SETS; set++) {
      requireExact(device, new GrazingLegs(random, SIZE, POINTS), firstNanos);
    }
  }

  /** Returns voxels of which no two share a corner, so that a verdict depends on a single voxel. */
  static BitCube isolatedVoxels() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int k = 0; k < SIZE; k += 2) {
      for (int j = 0; j < SIZE; j += 2) {
        for (int i = 0; i < SIZE; i += 2) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  private static void requireExact(OpenClDevice device, GrazingLegs legs, long firstNanos) {
    BitCube bits = isolatedVoxels();
    OpenClLegs batch = device.newBatch(bits, legs);
    LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(legs);
    for (int group = 0; group < GrazingLegs.GROUPS; group++) {
      MotionGroup motions = legs.group(group);
      batch.judge(motions, firstNanos);
      exact.judge(motions);
      for (int n = 0; n < POINTS * motions.count(); n++) {
        if (!batch.isRight(n / POINTS, n % POINTS, exact)) {
          throw new IllegalStateException("its arithmetic is not exact, so it cannot be used");
        }
      }
    }
  }
}
