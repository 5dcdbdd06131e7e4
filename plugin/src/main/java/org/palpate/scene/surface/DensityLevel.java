package org.palpate.scene.surface;

import java.util.List;
import org.palpate.volume.BitCube;

/** The density of the cells of a coarse grid, 0 to 1, interpolated between their middles. */
final class DensityLevel {
  private static final int FULL = 255;

  private final int sizeX;
  private final int sizeY;
  private final int sizeZ;
  private final int shift;
  private final byte[] density;

  private DensityLevel(int sizeX, int sizeY, int sizeZ, int shift) {
    this.sizeX = sizeX;
    this.sizeY = sizeY;
    this.sizeZ = sizeZ;
    this.shift = shift;
    density = new byte[Math.multiplyExact(Math.multiplyExact(sizeX, sizeY), sizeZ)];
  }

  /** Returns the density of the bricks of cubes of equal size, taken together. */
  static DensityLevel ofBricks(List<BitCube> cubes) {
    BitCube first = cubes.get(0);
    DensityLevel level =
        new DensityLevel(first.bricksX(), first.bricksY(), first.bricksZ(), BitCube.BRICK_SHIFT);
    for (int z = 0; z < level.sizeZ; z++) {
      for (int y = 0; y < level.sizeY; y++) {
        for (int x = 0; x < level.sizeX; x++) {
          long together = 0;
          for (BitCube cube : cubes) {
            together |= cube.brick(x, y, z);
          }
          level.density[level.index(x, y, z)] = (byte) (Long.bitCount(together) * FULL / 64);
        }
      }
    }
    return level;
  }

  /** Returns the level with cells of twice the size. */
  DensityLevel half() {
    DensityLevel half =
        new DensityLevel((sizeX + 1) / 2, (sizeY + 1) / 2, (sizeZ + 1) / 2, shift + 1);
    for (int z = 0; z < half.sizeZ; z++) {
      for (int y = 0; y < half.sizeY; y++) {
        for (int x = 0; x < half.sizeX; x++) {
          half.density[half.index(x, y, z)] = (byte) meanOfEight(2 * x, 2 * y, 2 * z);
        }
      }
    }
    return half;
  }

  private int meanOfEight(int x, int y, int z) {
    int sum = 0;
    for (int corner = 0; corner < 8; corner++) {
      sum += cell(x + (corner & 1), y + ((corner >> 1) & 1), z + (corner >> 2));
    }
    return sum / 8;
  }

  /** Returns the density at a point in grid coordinates; 0 outside the grid. */
  float at(float x, float y, float z) {
    float cell = 1f / (1 << shift);
    float u = x * cell - 0.5f;
    float v = y * cell - 0.5f;
    float w = z * cell - 0.5f;
    int i = floor(u);
    int j = floor(v);
    int k = floor(w);
    u -= i;
    v -= j;
    w -= k;
    boolean isWithin =
        i >= 0 && j >= 0 && k >= 0 && i < sizeX - 1 && j < sizeY - 1 && k < sizeZ - 1;
    return (isWithin ? within(index(i, j, k), u, v, w) : atBorder(i, j, k, u, v, w)) / FULL;
  }

  private static int floor(float value) {
    int towardsZero = (int) value;
    return value < towardsZero ? towardsZero - 1 : towardsZero;
  }

  /** Interpolates between eight cells inside the grid; {@code at} is the index of the first. */
  private float within(int at, float u, float v, float w) {
    int plane = sizeX * sizeY;
    float low = mix(row(at, u), row(at + sizeX, u), v);
    float high = mix(row(at + plane, u), row(at + plane + sizeX, u), v);
    return mix(low, high, w);
  }

  private float row(int at, float u) {
    return mix(density[at] & 255, density[at + 1] & 255, u);
  }

  private float atBorder(int i, int j, int k, float u, float v, float w) {
    float low = mix(row(i, j, k, u), row(i, j + 1, k, u), v);
    float high = mix(row(i, j, k + 1, u), row(i, j + 1, k + 1, u), v);
    return mix(low, high, w);
  }

  private float row(int i, int j, int k, float u) {
    return mix(cell(i, j, k), cell(i + 1, j, k), u);
  }

  private static float mix(float a, float b, float fraction) {
    return a + (b - a) * fraction;
  }

  private int cell(int x, int y, int z) {
    boolean inside = x >= 0 && x < sizeX && y >= 0 && y < sizeY && z >= 0 && z < sizeZ;
    return inside ? density[index(x, y, z)] & 255 : 0;
  }

  private int index(int x, int y, int z) {
    return (z * sizeY + y) * sizeX + x;
  }
}
