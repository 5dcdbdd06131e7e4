package org.palpate.scene.surface;

import java.util.List;
import org.palpate.volume.BitCube;

/**
 * Ambient occlusion from the density of the bricks in front of a point. It looks in five directions
 * around the normal at three distances, the farther the coarser.
 *
 * <p>It uses the voxel counts of 4x4x4 bricks, so it needs one byte for 64 voxels and one pass over
 * the words. It is a copy: later edits do not change it.
 */
public final class DensityAmbientOcclusion implements AmbientOcclusion {
  private static final int LEVELS = 3;

  /** Attenuation of the light by the density; chosen by eye on a skull. */
  private static final float STRENGTH = 2.0f;

  private static final float TILT_COS = 0.57f;
  private static final float TILT_SIN = 0.82f;
  private static final int DIRECTIONS = 5;

  private final DensityLevel[] levels = new DensityLevel[LEVELS];

  /** Creates the ambient occlusion among cubes of equal size. */
  public DensityAmbientOcclusion(List<BitCube> cubes) {
    levels[0] = DensityLevel.ofBricks(cubes);
    for (int level = 1; level < LEVELS; level++) {
      levels[level] = levels[level - 1].half();
    }
  }

  @Override
  public float at(float x, float y, float z, float nx, float ny, float nz) {
    // Two directions perpendicular to the normal, by cross products with the axis farthest from it.
    boolean alongX = Math.abs(nx) < 0.6f;
    float ux = alongX ? 0 : nz;
    float uy = alongX ? nz : 0;
    float uz = alongX ? -ny : -nx;
    float scale = 1 / (float) Math.sqrt(ux * ux + uy * uy + uz * uz + 1e-12f);
    ux *= scale;
    uy *= scale;
    uz *= scale;
    float vx = ny * uz - nz * uy;
    float vy = nz * ux - nx * uz;
    float vz = nx * uy - ny * ux;
    float blocked = 2 * blocked(x, y, z, nx, ny, nz);
    for (int turn = 0; turn < DIRECTIONS - 1; turn++) {
      float a = turn < 2 ? TILT_SIN * (1 - 2 * turn) : 0;
      float b = turn < 2 ? 0 : TILT_SIN * (5 - 2 * turn);
      blocked +=
          blocked(
              x,
              y,
              z,
              TILT_COS * nx + a * ux + b * vx,
              TILT_COS * ny + a * uy + b * vy,
              TILT_COS * nz + a * uz + b * vz);
    }
    return (float) Math.exp(-STRENGTH * blocked / (DIRECTIONS + 1));
  }

  private float blocked(float x, float y, float z, float dx, float dy, float dz) {
    float sum = 0;
    float distance = 5;
    for (DensityLevel level : levels) {
      sum += level.at(x + dx * distance, y + dy * distance, z + dz * distance);
      distance *= 2;
    }
    return sum;
  }
}
