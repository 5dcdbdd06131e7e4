package org.palpate.rigid;

import java.util.Optional;
import java.util.SplittableRandom;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.collision.LegBatch;
import org.palpate.collision.LegVerdict;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.PointSet;
import org.palpate.volume.BitCube;

/**
 * A collision device with a copy of the voxels, as one on a card has. It sees a changed voxel only
 * if it was told. It doubts some verdicts, and sometimes fails, at random.
 */
final class CopyingDevice implements CollisionDevice {
  private final SplittableRandom random;
  private final long crossover;

  /** Whether every leg is called free, which is a lie. */
  private final boolean lies;

  private long batches;
  private long motions;

  CopyingDevice(SplittableRandom random, long crossover, boolean lies) {
    this.random = random;
    this.crossover = crossover;
    this.lies = lies;
  }

  @Override
  public long batches() {
    return batches;
  }

  /** Returns the number of motions that the batches judged. */
  long motions() {
    return motions;
  }

  @Override
  public String name() {
    return "copying";
  }

  @Override
  public Optional<String> failure() {
    return Optional.empty();
  }

  @Override
  public void close() {}

  @Override
  public DeviceVoxels keep(BitCube voxels) {
    BitCube copy = voxels.copy();
    return new DeviceVoxels() {
      @Override
      public void voxelsChanged(IntBox box) {
        for (int k = Math.max(0, box.lowZ); k <= Math.min(copy.sizeZ() - 1, box.highZ); k++) {
          for (int j = Math.max(0, box.lowY); j <= Math.min(copy.sizeY() - 1, box.highY); j++) {
            for (int i = Math.max(0, box.lowX); i <= Math.min(copy.sizeX() - 1, box.highX); i++) {
              if (voxels.get(i, j, k)) {
                copy.set(i, j, k);
              } else {
                copy.clear(i, j, k);
              }
            }
          }
        }
      }

      @Override
      public LegBatch newBatch(PointSet points) {
        return new Batch(CPU.keep(copy).newBatch(points));
      }
    };
  }

  private final class Batch implements LegBatch {
    private final LegBatch exact;

    Batch(LegBatch exact) {
      this.exact = exact;
    }

    @Override
    public long crossover() {
      return crossover;
    }

    @Override
    public int motionsAtOnce() {
      return MotionGroup.CAPACITY;
    }

    @Override
    public boolean judge(MotionGroup group) {
      batches++;
      motions += group.count();
      return random.nextInt(16) != 0 && exact.judge(group);
    }

    @Override
    public LegVerdict verdict(int motion, int point) {
      if (lies) {
        return LegVerdict.FREE;
      }
      return random.nextInt(8) == 0 ? LegVerdict.DOUBT : exact.verdict(motion, point);
    }

    @Override
    public double emptyAround(int point) {
      return random.nextInt(8) == 0 ? 0 : exact.emptyAround(point);
    }
  }
}
