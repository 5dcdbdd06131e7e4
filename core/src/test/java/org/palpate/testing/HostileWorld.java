package org.palpate.testing;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/** Makes small scenes and motions of a hand that break naive geometry, from random numbers. */
public final class HostileWorld {
  private HostileWorld() {}

  /** Moves the device by a hostile step, or leaves it at rest. */
  public static void moveDevice(SplittableRandom random, BitCube bits, Vec3 device) {
    switch (random.nextInt(6)) {
      case 0 -> device.set(point(random, bits));
      case 1 -> {} // at rest
      case 2 ->
          device.set(
              device.x + random.nextInt(-1, 2) * 0.5,
              device.y + random.nextInt(-1, 2) * 0.5,
              device.z + random.nextInt(-1, 2) * 0.5);
      case 3 -> device.set(Math.nextUp(device.x), Math.nextDown(device.y), device.z);
      default ->
          device.set(
              device.x + random.nextDouble(-1, 1),
              device.y + random.nextDouble(-1, 1),
              device.z + random.nextDouble(-1, 1));
    }
  }

  /** Returns a point with hostile coordinates in or about the grid. */
  public static Vec3 point(SplittableRandom random, BitCube bits) {
    return new Vec3(
        HostileNumbers.coordinate(random, bits.sizeX()),
        HostileNumbers.coordinate(random, bits.sizeY()),
        HostileNumbers.coordinate(random, bits.sizeZ()));
  }

  /**
   * Returns a checkerboard, walls whose voxels share only edges or corners, or noise. A grid has at
   * most 15 voxels an edge.
   */
  public static BitCube scene(SplittableRandom random) {
    BitCube bits = new BitCube(random.nextInt(1, 16), random.nextInt(1, 16), random.nextInt(1, 16));
    double density = random.nextDouble() * random.nextDouble();
    int pattern = random.nextInt(4);
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          boolean solid =
              switch (pattern) {
                case 0 -> (i + j + k) % 2 == 0; // checkerboard
                case 1 -> (i + j) % 4 == 0; // walls whose voxels share only edges
                case 2 -> (i + j + k) % 5 == 0; // walls whose voxels share edges and corners
                default -> random.nextDouble() < density;
              };
          if (solid) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
