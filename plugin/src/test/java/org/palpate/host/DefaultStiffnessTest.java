package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

class DefaultStiffnessTest {
  @ParameterizedTest
  @ValueSource(doubles = {0.125, 0.2, 1, 1.5, 3.9})
  void scenesOfUsualExtentHaveHalfANewtonPerMillimetre(double spacingMm) {
    assertEquals(0.5, ContactSettings.defaultStiffnessNewtonPerMm(grid(spacingMm)));
  }

  @Test
  void aScanOfMicrometresFeelsAsTheSameScanOfMillimetres() {
    double coarse = 1 * ContactSettings.defaultStiffnessNewtonPerMm(grid(1));
    double fine = 0.001 * ContactSettings.defaultStiffnessNewtonPerMm(grid(0.001));
    assertEquals(coarse, fine, 1e-12, "force for a depth of one voxel");
  }

  @Test
  void theStiffnessOfSmallerScenesGrowsWithoutAJump() {
    double last = ContactSettings.defaultStiffnessNewtonPerMm(grid(0.2));
    for (double spacing = 0.2; spacing > 1e-6; spacing /= 1.01) {
      double next = ContactSettings.defaultStiffnessNewtonPerMm(grid(spacing));
      assertTrue(next >= last && next <= 1.02 * last, spacing + " mm: " + next);
      last = next;
    }
  }

  @Test
  void aSceneThatIsLargerThanARoomIsSofter() {
    assertEquals(
        0.5 * 1000 / 256_000, ContactSettings.defaultStiffnessNewtonPerMm(grid(1000)), 1e-12);
  }

  private static VoxelGrid grid(double spacingMm) {
    return new VoxelGrid(
        256, 128, 64, new Vec3(spacingMm, spacingMm, spacingMm), RigidTransform.identity());
  }
}
