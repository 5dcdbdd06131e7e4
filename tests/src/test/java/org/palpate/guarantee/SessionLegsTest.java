package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.host.SolverKind;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.proxy.smooth.field.GreyIsosurface;
import org.palpate.testing.Scans;
import org.palpate.testing.Seeds;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.Phantom;

class SessionLegsTest {
  private static final int FRAMES = 10_000;

  @ParameterizedTest
  @CsvSource({
    "head:128, GUARDED", "sphere:96, GUARDED", "shell:96, GUARDED",
    "plane:96, GUARDED", "torus:96, GUARDED", "maze:64, GUARDED",
    "head:128, SMOOTH", "sphere:96, SMOOTH", "shell:96, SMOOTH",
    "plane:96, SMOOTH", "torus:96, SMOOTH", "maze:64, SMOOTH"
  })
  void noLegTouchesASolidOnAPhantom(String phantom, SolverKind solver) throws IOException {
    assertKept(phantom, Phantom.parse(phantom).segments(), solver);
  }

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, bone=>=1500, GUARDED",
    "CThead/CThead_u16gz.nrrd, bone=>=1500, SMOOTH",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, bone=nonzero, GUARDED",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, bone=nonzero, SMOOTH",
    "labels/HN-Atlas-labels.nrrd, all=nonzero, GUARDED",
    "labels/HN-Atlas-labels.nrrd, all=nonzero, SMOOTH",
    "labels/Skull.nrrd, skull=nonzero, GUARDED",
    "totalseg/example_ct.nii.gz, bone=>=200, GUARDED"
  })
  void noLegTouchesASolidOnAScan(String file, String segment, SolverKind solver)
      throws IOException {
    assertKept(file, scan(file, segment), solver);
  }

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, 1500",
    "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd, 200",
    "totalseg/example_ct.nii.gz, 200"
  })
  void noLegTouchesASolidIfGreyValuesMakeTheSurface(String file, double threshold)
      throws IOException {
    SegmentedVolume volume = scan(file, "bone=>=" + threshold);
    GreyIsosurface grey =
        GreyIsosurface.ofThreshold(
            GreyVolumes.read(VolumeFiles.open(Scans.file(file), ReadOptions.defaults())),
            threshold);
    assertKept(
        file,
        SolverKind.SMOOTH,
        SessionLegs.of(volume, SolverKind.SMOOTH, Optional.of(grey), Seeds.seed(), FRAMES));
  }

  private static void assertKept(String name, SegmentedVolume volume, SolverKind solver)
      throws IOException {
    assertKept(name, solver, SessionLegs.of(volume, solver, Seeds.seed(), FRAMES));
  }

  private static void assertKept(String name, SolverKind solver, SessionLegs session) {
    long seed = Seeds.seed();
    String where = name + " by " + solver + ", seed " + seed + ": " + session.firstFault();
    assertEquals(0, session.legsThroughSolids(), where);
    assertEquals(0, session.brokenChains(), where);
    assertTrue(
        session.contactFrames() > FRAMES / 20, where + " contact " + session.contactFrames());
  }

  @ParameterizedTest
  @CsvSource({"head:128", "sphere:96", "shell:96", "plane:96", "torus:96", "maze:64"})
  void theBaselinesPassThroughSolidsOfAPhantom(String name) throws IOException {
    assertBroken(name, Phantom.parse(name).segments());
  }

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, bone=>=1500",
    "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd, bone=nonzero",
    "labels/HN-Atlas-labels.nrrd, all=nonzero"
  })
  void theBaselinesPassThroughSolidsOfAScan(String file, String segment) throws IOException {
    assertBroken(file, scan(file, segment));
  }

  private static void assertBroken(String name, SegmentedVolume volume) throws IOException {
    for (SolverKind solver : List.of(SolverKind.PAPER, SolverKind.DOT)) {
      SessionLegs session = SessionLegs.of(volume, solver, 1, FRAMES);
      System.out.printf(
          Locale.ROOT,
          "%s on %s: %,d of %,d legs touch a solid%n",
          solver,
          name,
          session.legsThroughSolids(),
          session.legs());
      assertTrue(
          session.legsThroughSolids() > 0,
          solver + " on " + name + " kept the guarantee, which docs/guarantee.md denies");
    }
  }

  private static SegmentedVolume scan(String name, String segment) throws IOException {
    return SegmentBuilder.read(
        VolumeFiles.open(Scans.file(name), ReadOptions.defaults()),
        List.of(SegmentSpec.parse(segment)));
  }
}
