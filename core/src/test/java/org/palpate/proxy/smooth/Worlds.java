package org.palpate.proxy.smooth;

import java.util.List;
import java.util.SplittableRandom;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/** Small scenes that are hard to slide on. */
final class Worlds {
  /** The voxels along an edge of each. */
  static final int EDGE = 40;

  /** The names of all scenes. */
  static final List<String> NAMES =
      List.of(
          "dust",
          "sponge",
          "maze",
          "comb",
          "slits",
          "holes",
          "checkerboard",
          "wire",
          "cube",
          "corner",
          "wedge",
          "slope",
          "needles",
          "sheet");

  /** One in this many grey values contradicts its bit. */
  private static final int RARE = 50;

  private static final double THRESHOLD = 500;

  private Worlds() {}

  /**
   * Makes grey values for a scene: those beside a surface lie nearer to the threshold, and some
   * contradict their bits.
   */
  static GreyIsosurface grey(BitCube bits, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    ScalarVolume values =
        ScalarVolume.of(VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE), ScalarVolume.Storage.INT16);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          double part = partAround(bits, i, j, k);
          boolean isAbove = bits.get(i, j, k) != (random.nextInt(RARE) == 0);
          values.set(i, j, k, Math.rint(THRESHOLD * (isAbove ? 1 + part : part * 0.99)));
        }
      }
    }
    return new GreyIsosurface(values, THRESHOLD, THRESHOLD);
  }

  /** Returns the solid part of a voxel and those around it. */
  private static double partAround(BitCube bits, int i, int j, int k) {
    int solid = 0;
    for (int n = 0; n < 27; n++) {
      solid += bits.get(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1) ? 1 : 0;
    }
    return solid / 27.0;
  }

  /** Makes a scene, the same for the same seed. */
  static BitCube make(String name, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (isSolid(name, i, j, k, random)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private static boolean isSolid(String name, int i, int j, int k, SplittableRandom random) {
    return switch (name) {
      case "dust" -> random.nextDouble() < 0.03;
      case "sponge" -> random.nextDouble() < 0.35;
      case "maze" -> isMaze(i, j, k, random);
      case "comb" -> k < 20 && i % 6 < 3;
      case "slits" -> k < 20 && i % (2 + j / 8) != 0;
      case "holes" -> k < 25 && !(i % 7 < 1 + j / 12 && j % 7 < 1 + j / 12);
      case "checkerboard" -> k < 20 && (i + j + k) % 2 == 0;
      case "wire" -> j == 20 && k == 20;
      case "cube" -> isBetween(i, 12, 28) && isBetween(j, 12, 28) && isBetween(k, 12, 28);
      case "corner" -> i < 12 || k < 12;
      case "wedge" -> k < 20 && Math.abs(i - 20) < (20 - k) * 0.5;
      case "slope" -> i + 2 * j + 3 * k < 120;
      case "needles" -> i % 5 == 0 && j % 5 == 0 && k < 30;
      case "sheet" -> k == 20 && random.nextDouble() < 0.97;
      default -> throw new IllegalArgumentException("no such scene: " + name);
    };
  }

  private static boolean isBetween(int v, int low, int high) {
    return v >= low && v < high;
  }

  /** Whether a voxel belongs to walls every five voxels, with random holes. */
  private static boolean isMaze(int i, int j, int k, SplittableRandom random) {
    boolean wall = i % 5 == 0 || j % 5 == 0 || k % 5 == 0;
    return wall && random.nextDouble() < 0.85;
  }
}
