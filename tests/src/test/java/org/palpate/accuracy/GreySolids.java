package org.palpate.accuracy;

import java.util.SplittableRandom;
import org.palpate.benchmarks.accuracy.SampledSolids;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.PhantomSlices;

/** Grey values of a phantom with noise, and the bits above half of the full value. */
final class GreySolids {
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
    volume = SampledSolids.greyOf(truth, edgeMm, spacingMm);
    bits = SampledSolids.threshold(volume);
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
