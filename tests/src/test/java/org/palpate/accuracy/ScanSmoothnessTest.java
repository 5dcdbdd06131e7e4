package org.palpate.accuracy;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Assumptions;
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
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;

/** Slides on real scans, where no truth is known: smooth, without sticking, alike both ways. */
class ScanSmoothnessTest {
  private static final double MAX_STEP_MM = 16;

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, 1500, 2",
    "CThead/CThead_u16gz.nrrd, 1500, 5",
    "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd, 200, 2"
  })
  void aSlideOnBoneIsSmoothAndAlikeBothWays(String file, double threshold, double depthMm)
      throws IOException {
    Path path = data(file);
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
    List<Vec3> way = ScanSlide.below(bits, spacing, depthMm);
    SlideSmoothness guarded =
        SlideSmoothness.of(new GuardedSolver(metric, MAX_STEP_MM), bits, metric, way);
    SlideSmoothness smooth =
        SlideSmoothness.of(new SmoothSolver(metric, MAX_STEP_MM), bits, metric, way);
    SlideSmoothness greys =
        SlideSmoothness.of(new SmoothSolver(metric, MAX_STEP_MM, grey), bits, metric, way);
    tell(file + ", " + depthMm + " mm, " + way.size() + " frames", guarded, smooth, greys);
    for (SlideSmoothness feel : List.of(smooth, greys)) {
      assertTrue(feel.contactShare() > 0.99, feel::toString);
      assertTrue(feel.change() < 0.2 && feel.change() < guarded.change() / 10, feel::toString);
      assertTrue(feel.worstChange() < 1, feel::toString);
      assertTrue(feel.stuckMm() < 0.4, feel::toString);
      assertTrue(feel.asymmetry() < 0.03, feel::toString);
    }
  }

  private static void tell(
      String what, SlideSmoothness guarded, SlideSmoothness smooth, SlideSmoothness greys) {
    System.out.println(what);
    System.out.println("  guarded " + line(guarded));
    System.out.println("  smooth  " + line(smooth));
    System.out.println("  grey    " + line(greys));
  }

  private static String line(SlideSmoothness feel) {
    return String.format(
        Locale.ROOT,
        "change %.2f, worst %.1f, stays for %.1f mm, there and back %.1f %%, contact %.0f %%",
        feel.change(),
        feel.worstChange(),
        feel.stuckMm(),
        100 * feel.asymmetry(),
        100 * feel.contactShare());
  }

  private static Path data(String name) {
    Path file = Path.of(System.getProperty("palpate.data", "../shared/data"), name);
    Assumptions.assumeTrue(
        Files.exists(file), () -> "skipped: there is no " + file + " (-Dpalpate.data=DIR)");
    return file;
  }
}
