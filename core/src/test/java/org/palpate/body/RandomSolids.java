package org.palpate.body;

import java.util.SplittableRandom;
import org.palpate.volume.BitCube;

/** Bit cubes for tests: balls, dust and walls at random. */
public final class RandomSolids {
  private RandomSolids() {}

  /** Returns a cube with some balls, a wall one voxel thick and a little dust. */
  public static BitCube clutter(SplittableRandom random, int sizeX, int sizeY, int sizeZ) {
    BitCube bits = new BitCube(sizeX, sizeY, sizeZ);
    for (int n = 0; n < 3; n++) {
      addBall(
          bits, random, random.nextDouble(1, 0.2 * Math.min(sizeX, Math.min(sizeY, sizeZ)) + 2));
    }
    int wall = random.nextInt(sizeX);
    for (int k = 0; k < sizeZ / 2; k++) {
      for (int j = 0; j < sizeY / 2; j++) {
        bits.set(wall, j, k);
      }
    }
    for (int n = 0; n < 6; n++) {
      bits.set(random.nextInt(sizeX), random.nextInt(sizeY), random.nextInt(sizeZ));
    }
    return bits;
  }

  private static void addBall(BitCube bits, SplittableRandom random, double radius) {
    double x = random.nextDouble(bits.sizeX());
    double y = random.nextDouble(bits.sizeY());
    double z = random.nextDouble(bits.sizeZ());
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          double dx = i + 0.5 - x;
          double dy = j + 0.5 - y;
          double dz = k + 0.5 - z;
          if (dx * dx + dy * dy + dz * dz < radius * radius) {
            bits.set(i, j, k);
          }
        }
      }
    }
  }
}
