package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.Fragments;

/** The readings of two cuboids of 4 x 4 x 2 voxels, one on the other at rest. */
class FractureReportTest {
  private static FractureReport report(double liftMm) {
    return new FractureReport(bodies(liftMm));
  }

  private static PlacedVolume bodies(double liftMm) {
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
    return PlacedVolume.ofFragments(fragments, List.of(new Pose(), lift), CoordinateSystem.LPS);
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
  void aBodyThatCanMoveIsReadAgainstEachGhost() {
    PlacedVolume moved = bodies(1);
    SegmentedVolume ghosts =
        new SegmentedVolume(
            moved.rest().grid(),
            List.of(new Segment("ghost", moved.rest().segments().get(1).bits(), 0)));
    FractureReport report = new FractureReport(moved, Optional.of(ghosts));
    List<String> lines =
        report.lines().stream().filter(line -> line.contains(" to ghost: ")).toList();
    assertEquals(1, lines.size(), lines::toString);
    assertTrue(
        lines
            .get(0)
            .matches(
                "fragment2 to ghost: distance \\d\\.\\d\\d mm, 95 % under \\d\\.\\d\\d,"
                    + " at most \\d\\.\\d\\d; read on \\d+ % of its surface"),
        lines.get(0));
    Map<?, ?> entry = (Map<?, ?>) ((List<?>) report.field().get("ghosts")).get(0);
    assertEquals(List.of("fragment2", "ghost"), List.of(entry.get("body"), entry.get("ghost")));
    assertTrue((double) entry.get("distance_largest_mm") > 0.7, entry::toString);
    assertFalse(report(1).field().containsKey("ghosts"));
  }

  @Test
  void fragmentsThatTouchDoNotOverlap() {
    assertFalse(report(0).overlaps());
    List<String> lines = report(0).lines();
    assertEquals(List.of(), lines.stream().filter(line -> line.contains(" overlap in ")).toList());
  }
}
