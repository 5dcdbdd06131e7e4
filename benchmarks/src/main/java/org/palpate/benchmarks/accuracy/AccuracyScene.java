package org.palpate.benchmarks.accuracy;

import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.PhantomSlices;

/**
 * A phantom as bits and as grey values, with its analytic surface. Pixels are 1 mm wide. The
 * distance between slices may be larger, and a slice is as thick as that distance.
 */
final class AccuracyScene {
  final AnalyticSurface truth;
  final GridMetric metric;
  final BitCube bits;
  final CollisionScene collisionScene;

  /** The isosurface of the grey values. */
  final GreyIsosurface grey;

  /** The solids that a threshold makes from the grey values. */
  final CollisionScene greyCollisionScene;

  /**
   * Makes a phantom of a kind.
   *
   * @param edge the edge of the cube that it fills, mm
   * @param sliceMm the distance between slices
   */
  AccuracyScene(String kind, int edge, int sliceMm) {
    Phantom phantom = Phantom.parse(kind + ":" + edge);
    truth = phantom.analyticSurface().orElseThrow();
    metric = new GridMetric(1, 1, sliceMm);
    bits =
        sliceMm == 1
            ? phantom.segments().segments().get(0).bits()
            : SampledSolids.of(truth, edge, new Vec3(1, 1, sliceMm));
    collisionScene = new CollisionScene(List.of(bits));
    ScalarVolume volume = read(Phantom.parse(kind + ":" + edge + ":grey"), sliceMm);
    grey = new GreyIsosurface(volume, Phantom.HALF_GREY, Phantom.HALF_GREY);
    greyCollisionScene = new CollisionScene(List.of(threshold(volume)));
  }

  /** Reads grey values; a slice is the mean of all slices of 1 mm that it covers. */
  private static ScalarVolume read(Phantom phantom, int sliceMm) {
    int edge = phantom.edge();
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(edge, edge, edge / sliceMm);
    ScalarVolume volume = ScalarVolume.of(grid, Storage.INT16);
    PhantomSlices slices = phantom.slices();
    short[] slice = new short[edge * edge];
    for (int k = 0; k < grid.sizeZ(); k++) {
      int[] sums = new int[edge * edge];
      for (int thin = k * sliceMm; thin < (k + 1) * sliceMm; thin++) {
        slices.read(thin, slice);
        for (int n = 0; n < sums.length; n++) {
          sums[n] += slice[n];
        }
      }
      for (int n = 0; n < sums.length; n++) {
        volume.set(n % edge, n / edge, k, Math.rint(sums[n] / (double) sliceMm));
      }
    }
    return volume;
  }

  private static BitCube threshold(ScalarVolume volume) {
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

  /** Writes a position in millimetres as grid coordinates. */
  Vec3 toGrid(Vec3 mm, Vec3 dest) {
    return dest.set(mm.x / metric.spacingX(), mm.y / metric.spacingY(), mm.z / metric.spacingZ());
  }

  /** Writes a vector in grid coordinates as millimetres. */
  Vec3 toMm(Vec3 grid, Vec3 dest) {
    return dest.set(
        grid.x * metric.spacingX(), grid.y * metric.spacingY(), grid.z * metric.spacingZ());
  }
}
