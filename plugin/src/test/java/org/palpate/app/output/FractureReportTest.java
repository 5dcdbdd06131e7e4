package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.Fragments;

/** The readings of two cuboids of 4 x 4 x 2 voxels, one on the other at rest. */
class FractureReportTest {
  private static FractureReport report(double liftMm) {
    BitCube low = new BitCube(8, 8, 8);
    BitCube high = new BitCube(8, 8, 8);
    for (int n = 0; n < 16; n++) {
      low.set(n % 4, n / 4, 0);
      low.set(n % 4, n / 4, 1);
      high.set(n % 4, n / 4, 2);
      high.set(n % 4, n / 4, 3);
    }
    Fragments fragments = new Fragments(VoxelGrid.ofUnitVoxels(8, 8, 8), List.of(low, high), 0);
    Pose lift = new Pose();
    lift.translation.z = liftMm;
    return new FractureReport(
        PlacedVolume.ofFragments(fragments, List.of(new Pose(), lift), CoordinateSystem.LPS));
  }

  @Test
  void fragmentsThatOverlapAreNamedWithTheirVoxels() {
    FractureReport sunk = report(-0.5);
    assertTrue(sunk.overlaps());
    String line = "fragment2 and fragment1 overlap in 16 pairs of voxels";
    assertTrue(sunk.lines().contains(line), sunk.lines().toString());
    assertTrue(
        sunk.lines().get(sunk.lines().size() - 1).endsWith("; 16 overlapping pairs of voxels"));
  }

  @Test
  void fragmentsThatTouchDoNotOverlap() {
    assertFalse(report(0).overlaps());
    List<String> lines = report(0).lines();
    assertEquals(List.of(), lines.stream().filter(line -> line.contains(" overlap in ")).toList());
  }
}
