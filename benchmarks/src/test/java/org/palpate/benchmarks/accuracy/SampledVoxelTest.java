package org.palpate.benchmarks.accuracy;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

class SampledVoxelTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_129);
  private static final int SAMPLES_PER_MM = 5;

  private final SplittableRandom random = new SplittableRandom(SEED);

  /** Decides each sample by a distance of its own. */
  private static double naive(AnalyticSurface truth, Vec3 corner, Vec3 spacing) {
    int countX = (int) Math.ceil(SAMPLES_PER_MM * spacing.x);
    int countY = (int) Math.ceil(SAMPLES_PER_MM * spacing.y);
    int countZ = (int) Math.ceil(SAMPLES_PER_MM * spacing.z);
    int solid = 0;
    Vec3 at = new Vec3();
    for (int n = 0; n < countX * countY * countZ; n++) {
      int row = n / countX % countY;
      int slice = n / (countX * countY);
      at.set(
          corner.x + (n % countX + 0.5) / countX * spacing.x,
          corner.y + (row + 0.5) / countY * spacing.y,
          corner.z + (slice + 0.5) / countZ * spacing.z);
      solid += truth.signedDistance(at) < 0 ? 1 : 0;
    }
    return solid / (double) (countX * countY * countZ);
  }

  @ParameterizedTest
  @ValueSource(strings = {"plane:32", "sphere:32", "torus:32"})
  void theFractionIsThatOfTheSamplesOneByOne(String spec) {
    AnalyticSurface truth = Phantom.parse(spec).analyticSurface().orElseThrow();
    int mixed = 0;
    for (int n = 0; n < 200; n++) {
      Vec3 spacing = new Vec3(edge(), edge(), edge());
      SampledVoxel voxel = new SampledVoxel(truth, spacing, SAMPLES_PER_MM);
      for (int m = 0; m < 50; m++) {
        Vec3 corner = new Vec3(place(), place(), place());
        double expected = naive(truth, corner, spacing);
        assertEquals(expected, voxel.solidFraction(corner), "at " + corner + " of " + spacing);
        mixed += expected > 0 && expected < 1 ? 1 : 0;
      }
    }
    assertTrue(mixed > 500, "voxels that the surface crosses: " + mixed);
  }

  private double edge() {
    return random.nextDouble(0.15, 4);
  }

  private double place() {
    return random.nextDouble(2, 26);
  }
}
