package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/**
 * Slides on real scans, without a known truth, are smooth, unstuck and alike in both directions.
 */
class ScanSmoothnessTest {
  private static final double MAX_STEP_MM = 16;

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, 1500, 2",
    "CThead/CThead_u16gz.nrrd, 1500, 5",
    "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd, 200, 2"
  })
  void aSlideOnBoneIsSmoothAndAlikeInBothDirections(String file, double threshold, double depthMm)
      throws IOException {
    Path path = Scans.file(file);
    SegmentedVolume volume =
        SegmentBuilder.read(
            VolumeFiles.open(path, ReadOptions.defaults()),
            List.of(SegmentSpec.parse("bone=>=" + threshold)));
    GreyIsosurface grey =
        GreyIsosurface.ofThreshold(
            GreyVolumes.read(VolumeFiles.open(path, ReadOptions.defaults())), threshold);
    BitCube bits = volume.segments().get(0).bits();
    Vec3 spacing = volume.grid().spacingMm();
    GridMetric metric = GridMetric.of(spacing);
    List<Vec3> positions = ScanSlide.below(bits, spacing, depthMm);
    SlideSmoothness guarded =
        SlideSmoothness.of(new GuardedSolver(metric, MAX_STEP_MM), bits, metric, positions);
    SlideSmoothness smooth =
        SlideSmoothness.of(new SmoothSolver(metric, MAX_STEP_MM), bits, metric, positions);
    SlideSmoothness greys =
        SlideSmoothness.of(new SmoothSolver(metric, MAX_STEP_MM, grey), bits, metric, positions);
    print(file + ", " + depthMm + " mm, " + positions.size() + " frames", guarded, smooth, greys);
    for (SlideSmoothness smoothness : List.of(smooth, greys)) {
      assertTrue(smoothness.contactFraction() > 0.99, smoothness::toString);
      assertTrue(
          smoothness.change() < 0.2 && smoothness.change() < guarded.change() / 10,
          smoothness::toString);
      assertTrue(smoothness.worstChange() < 1, smoothness::toString);
      assertTrue(smoothness.turnDegrees() < 0.4, smoothness::toString);
      assertTrue(smoothness.worstTurnDegrees() < 1.2, smoothness::toString);
      assertTrue(smoothness.stuckMm() < 0.4, smoothness::toString);
      assertTrue(smoothness.asymmetry() < 0.03, smoothness::toString);
    }
  }

  private static void print(
      String what, SlideSmoothness guarded, SlideSmoothness smooth, SlideSmoothness greys) {
    System.out.println(what);
    System.out.println("  guarded " + line(guarded));
    System.out.println("  smooth  " + line(smooth));
    System.out.println("  grey    " + line(greys));
  }

  private static String line(SlideSmoothness smoothness) {
    return String.format(
        Locale.ROOT,
        "change %.2f, worst %.1f, turn %.2f, worst %.1f degrees, stuck for %.1f mm, asymmetry %.1f"
            + " %%, contact %.0f %%",
        smoothness.change(),
        smoothness.worstChange(),
        smoothness.turnDegrees(),
        smoothness.worstTurnDegrees(),
        smoothness.stuckMm(),
        100 * smoothness.asymmetry(),
        100 * smoothness.contactFraction());
  }
}
