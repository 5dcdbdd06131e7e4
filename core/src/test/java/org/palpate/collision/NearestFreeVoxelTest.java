package org.palpate.collision;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class NearestFreeVoxelTest {

  @Test
  void findsTheNearestEmptyVoxelAndOfEquallyNearOnesTheLowestIndex() {
    long seed = Seeds.seed();
    SplittableRandom random = new SplittableRandom(seed);
    for (int scene = 0; scene < 300; scene++) {
      BitCube bits =
          new BitCube(random.nextInt(1, 14), random.nextInt(1, 14), random.nextInt(1, 14));
      fill(bits, random, random.nextInt(4));
      GridMetric metric =
          scene % 2 == 0
              ? new GridMetric(1, random.nextInt(1, 3), random.nextInt(1, 4))
              : new GridMetric(1, random.nextInt(1, 30), random.nextInt(1, 400));
      Vec3 from =
          new Vec3(
              random.nextInt(0, 2 * bits.sizeX()) * 0.5,
              random.nextInt(0, 2 * bits.sizeY()) * 0.5,
              random.nextInt(0, 2 * bits.sizeZ()) * 0.5);
      Vec3 found =
          new NearestFreeVoxel(metric).find(new CollisionScene(List.of(bits)), from, new Vec3());
      assertEquals(
          naive(bits, metric, from).toString(),
          found.toString(),
          "seed=" + seed + " scene=" + scene);
    }
  }

  /** Along the long axis the nearest free voxel is as far away as many voxels are wide. */
  @Test
  void flatVoxelsCostNoSearchFarBeyondTheSolids() {
    AtomicInteger reads = new AtomicInteger();
    BitCube bits =
        new BitCube(8, 8, 8) {
          @Override
          public long brick(int brickX, int brickY, int brickZ) {
            reads.incrementAndGet();
            return super.brick(brickX, brickY, brickZ);
          }
        };
    bits.set(4, 4, 4);
    CollisionScene scene = new CollisionScene(List.of(bits));
    for (double ratio : new double[] {1, 20, 1e3, 1e6, 1e24}) {
      reads.set(0);
      GridMetric metric = new GridMetric(1e-12, 1e-12, 1e-12 * ratio);
      new NearestFreeVoxel(metric).find(scene, new Vec3(4.5, 4.5, 4.95), new Vec3());
      assertTrue(reads.get() <= 125, "1:1:" + ratio + " took " + reads + " reads");
    }
  }

  private static void fill(BitCube bits, SplittableRandom random, int holes) {
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (holes == 0 || random.nextInt(40) >= holes) {
            bits.set(i, j, k);
          }
        }
      }
    }
  }

  /** Tests every voxel of the grid and of a sufficient margin, in the order of their indices. */
  private static Vec3 naive(BitCube bits, GridMetric metric, Vec3 from) {
    Vec3 best = new Vec3();
    double least = Double.POSITIVE_INFINITY;
    for (int k = -15; k < bits.sizeZ() + 15; k++) {
      for (int j = -15; j < bits.sizeY() + 15; j++) {
        for (int i = -15; i < bits.sizeX() + 15; i++) {
          double square = metric.squaredDistance(from.x, from.y, from.z, i + 0.5, j + 0.5, k + 0.5);
          if (!bits.get(i, j, k) && square < least) {
            least = square;
            best.set(i + 0.5, j + 0.5, k + 0.5);
          }
        }
      }
    }
    return best;
  }
}
