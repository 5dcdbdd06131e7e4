package org.palpate.accuracy;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.PhantomSlices;

/** Grey values of a phantom with noise, and the bits above half of the full value. */
final class GreySolids {
  /**
   * The samples of a voxel along each axis, for each millimetre. Fewer would leave steps in the
   * values where a surface is nearly parallel to the slices.
   */
  private static final int SAMPLES_PER_MM = 8;

  final ScalarVolume volume;
  final BitCube bits;

  /** Adds almost normal noise, a fraction of the full value, to every voxel. */
  GreySolids(Phantom phantom, double noise, long seed) {
    int edge = phantom.edge();
    volume = ScalarVolume.of(phantom.grid(), Storage.INT16);
    bits = new BitCube(edge, edge, edge);
    PhantomSlices slices = phantom.slices();
    short[] slice = new short[edge * edge];
    SplittableRandom random = new SplittableRandom(seed);
    for (int k = 0; k < edge; k++) {
      slices.read(k, slice);
      for (int n = 0; n < slice.length; n++) {
        double value = noise == 0 ? slice[n] : noisy(slice[n], noise, random);
        store(n % edge, n / edge, k, value);
      }
    }
  }

  /**
   * Samples an analytic surface: the value of a voxel is the solid fraction of its volume.
   *
   * @param edgeMm the edge of the cube that the voxels fill
   */
  GreySolids(AnalyticSurface truth, double edgeMm, Vec3 spacingMm) {
    int sizeX = (int) (edgeMm / spacingMm.x);
    int sizeY = (int) (edgeMm / spacingMm.y);
    int sizeZ = (int) (edgeMm / spacingMm.z);
    volume = ScalarVolume.of(VoxelGrid.ofUnitVoxels(sizeX, sizeY, sizeZ), Storage.INT16);
    bits = new BitCube(sizeX, sizeY, sizeZ);
    Vec3 corner = new Vec3();
    for (int k = 0; k < sizeZ; k++) {
      for (int j = 0; j < sizeY; j++) {
        for (int i = 0; i < sizeX; i++) {
          corner.set(i * spacingMm.x, j * spacingMm.y, k * spacingMm.z);
          double solid = solidFraction(truth, corner, spacingMm);
          store(i, j, k, Math.rint(Phantom.SOLID_GREY * solid));
        }
      }
    }
  }

  private static double solidFraction(AnalyticSurface truth, Vec3 corner, Vec3 spacingMm) {
    Vec3 at = spacingMm.mul(0.5, new Vec3());
    at.add(corner, at);
    double height = truth.signedDistance(at);
    if (Math.abs(height) > spacingMm.length() / 2) {
      return height < 0 ? 1 : 0;
    }
    int countX = samples(spacingMm.x);
    int countY = samples(spacingMm.y);
    int countZ = samples(spacingMm.z);
    int solid = 0;
    for (int z = 0; z < countZ; z++) {
      for (int y = 0; y < countY; y++) {
        for (int x = 0; x < countX; x++) {
          at.set(
              corner.x + (x + 0.5) / countX * spacingMm.x,
              corner.y + (y + 0.5) / countY * spacingMm.y,
              corner.z + (z + 0.5) / countZ * spacingMm.z);
          solid += truth.signedDistance(at) < 0 ? 1 : 0;
        }
      }
    }
    return solid / (double) (countX * countY * countZ);
  }

  private static int samples(double edgeMm) {
    return (int) Math.ceil(SAMPLES_PER_MM * edgeMm);
  }

  private static double noisy(double value, double noise, SplittableRandom random) {
    double sum = -6;
    for (int n = 0; n < 12; n++) {
      sum += random.nextDouble();
    }
    double full = Phantom.SOLID_GREY;
    return Math.rint(Math.max(0, Math.min(full, value + noise * full * sum)));
  }

  private void store(int i, int j, int k, double value) {
    volume.set(i, j, k, value);
    if (value >= Phantom.HALF_GREY) {
      bits.set(i, j, k);
    }
  }
}
