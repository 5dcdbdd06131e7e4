package org.palpate.opencl;

import java.util.Locale;
import java.util.SplittableRandom;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/** Compares verdicts of a device with those of the CPU, and counts them. */
final class VerdictCount {
  private static final int SIZE = 40;
  private static final int POINTS = 10_000;

  long legs;
  long free;
  long hit;
  long doubt;
  long falseFree;
  long falseHit;
  long cubes;
  long falseCubes;

  /** Judges legs that graze voxels until there are so many. */
  void addHostile(OpenClDevice device, SplittableRandom random, long most) {
    for (int round = 0; legs < most; round++) {
      BitCube bits =
          round % 2 == 0
              ? HostileSelfTest.isolatedVoxels()
              : noise(random, 0.02 * Math.pow(5, round / 2 % 3));
      GrazingLegs points = new GrazingLegs(random, SIZE, POINTS);
      OpenClLegs batch = device.newBatch(bits, points);
      LegBatch exact = CollisionDevice.CPU.keep(bits).newBatch(points);
      for (int group = 0; group < GrazingLegs.GROUPS && legs < most; group++) {
        add(batch, exact, points, points.group(group));
      }
    }
  }

  /** Judges the motions of a group in one launch. */
  void add(OpenClLegs batch, LegBatch exact, PointSet points, MotionGroup group) {
    batch.judge(group, OpenClOnCpu.PATIENT_NANOS);
    exact.judge(group);
    for (int n = 0; n < points.count(); n++) {
      for (int motion = 0; motion < group.count(); motion++) {
        count(batch.verdict(motion, n), exact.verdict(motion, n));
      }
      cubes++;
      falseCubes += batch.emptyAround(n) == exact.emptyAround(n) ? 0 : 1;
    }
  }

  private void count(LegVerdict verdict, LegVerdict truth) {
    legs++;
    switch (verdict) {
      case FREE -> {
        free++;
        falseFree += truth == LegVerdict.FREE ? 0 : 1;
      }
      case HIT -> {
        hit++;
        falseHit += truth == LegVerdict.HIT ? 0 : 1;
      }
      case DOUBT -> doubt++;
    }
  }

  /** Returns voxels at random. */
  static BitCube noise(SplittableRandom random, double share) {
    BitCube bits = new BitCube(SIZE, SIZE + 1, SIZE - 1);
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (random.nextDouble() < share) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%,d legs: %,d free, %,d hit, %,d in doubt; %,d falsely free, %,d falsely hit; %,d of %,d"
            + " cubes wrong",
        legs,
        free,
        hit,
        doubt,
        falseFree,
        falseHit,
        falseCubes,
        cubes);
  }
}
