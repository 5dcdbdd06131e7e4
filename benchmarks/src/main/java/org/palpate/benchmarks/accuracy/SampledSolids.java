package org.palpate.benchmarks.accuracy;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/** Samples an analytic surface with voxels of any size, as bits and as grey values. */
public final class SampledSolids {
  /**
   * The samples of a voxel along each axis, for each millimetre. Fewer would leave steps in the
   * values where a surface is nearly parallel to the slices.
   */
  private static final int SAMPLES_PER_MM = 8;

  private SampledSolids() {}

  /**
   * Returns the voxels whose centres are inside. The grid begins at the origin of the surface.
   *
   * @param truth the surface, mm
   * @param edgeMm the edge of the cube that the voxels fill
   */
  public static BitCube of(AnalyticSurface truth, double edgeMm, Vec3 spacingMm) {
    BitCube bits =
        new BitCube(
            (int) (edgeMm / spacingMm.x),
            (int) (edgeMm / spacingMm.y),
            (int) (edgeMm / spacingMm.z));
    Vec3 centre = new Vec3();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          centre.set((i + 0.5) * spacingMm.x, (j + 0.5) * spacingMm.y, (k + 0.5) * spacingMm.z);
          if (truth.signedDistance(centre) < 0) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  /**
   * Returns grey values: the solid fraction of each voxel, times {@link Phantom#SOLID_GREY}.
   *
   * @param truth the surface, mm
   * @param edgeMm the edge of the cube that the voxels fill
   */
  public static ScalarVolume greyOf(AnalyticSurface truth, double edgeMm, Vec3 spacingMm) {
    VoxelGrid grid =
        VoxelGrid.ofUnitVoxels(
            (int) (edgeMm / spacingMm.x),
            (int) (edgeMm / spacingMm.y),
            (int) (edgeMm / spacingMm.z));
    ScalarVolume volume = ScalarVolume.of(grid, Storage.INT16);
    SampledVoxel voxel = new SampledVoxel(truth, spacingMm, SAMPLES_PER_MM);
    Vec3 corner = new Vec3();
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          corner.set(i * spacingMm.x, j * spacingMm.y, k * spacingMm.z);
          volume.set(i, j, k, Math.rint(Phantom.SOLID_GREY * voxel.solidFraction(corner)));
        }
      }
    }
    return volume;
  }

  /** Returns the voxels whose grey value is at least half that of a solid. */
  public static BitCube threshold(ScalarVolume volume) {
    VoxelGrid grid = volume.grid();
    BitCube bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          if (volume.value(i, j, k) >= Phantom.HALF_GREY) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }
}
