package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.options.VolumeOptions;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.process.PalpateException;
import org.palpate.frame.FrameStatistics;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SolverKind;
import org.palpate.statistics.WorkPercentiles;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;
import picocli.CommandLine;

class ReportTest {
  @TempDir private Path folder;

  @Test
  void everyReportBeginsWithVersionJavaAndCommand() {
    Report report = new Report("replay", Optional.empty(), List.of());
    assertEquals(List.of("version", "java", "command"), List.copyOf(report.fields().keySet()));
    assertEquals("replay", report.fields().get("command"));
    assertTrue(report.fields().get("java").toString().startsWith("" + Runtime.version()));
    assertFalse(report.isWanted());
    report.write();
    assertThrows(UnsupportedOperationException.class, () -> report.fields().put("x", 1));
  }

  @Test
  void fieldsAreWrittenInTheirOrder() throws IOException {
    Path file = folder.resolve("r.json");
    Report report = new Report("info", Optional.of(file), List.of());
    assertTrue(report.isWanted());
    report.put("z", 1L).put("a", List.of("x")).write();
    String text = Files.readString(file);
    assertTrue(
        text.endsWith("  \"command\" : \"info\",\n  \"z\" : 1,\n  \"a\" : [ \"x\" ]\n}\n"), text);
  }

  @Test
  void aTargetThatCannotBeWrittenIsRefusedBeforeTheWork() throws IOException {
    Path input = Files.writeString(folder.resolve("in.csv"), "");
    PalpateException refusal =
        assertThrows(
            PalpateException.class, () -> new Report("info", Optional.of(input), List.of(input)));
    assertEquals(
        "the target is an input: --report " + input + ": name another file", refusal.getMessage());
    assertEquals(PalpateException.WRONG_USE, refusal.exitCode());
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
  void aFullDiskIsAFailureOfItsOwn() {
    Report report = new Report("info", Optional.of(Path.of("/dev/full")), List.of());
    PalpateException failure = assertThrows(PalpateException.class, report::write);
    assertEquals(
        "could not be written (No space left on device): /dev/full: check the disk and its"
            + " permissions",
        failure.getMessage());
    assertEquals(PalpateException.FAILED, failure.exitCode());
  }

  @Test
  void theVolumeIsDescribedWithItsSegments() throws IOException {
    VolumeSource source =
        VolumeSource.open(CommandLine.populateCommand(new VolumeOptions(), "--phantom=block:16"));
    SegmentedVolume volume = source.segments(new PrintWriter(new StringWriter()), false);
    List<Segment> segments =
        List.of(volume.segments().get(0), new Segment("none", new BitCube(16, 16, 16), 0));
    Report report = new Report("info", Optional.empty(), List.of());
    report.putVolume(source, segments);
    assertEquals("phantom block:16", report.fields().get("volume"));
    assertEquals(List.of(16, 16, 16), report.fields().get("sizes"));
    assertEquals(List.of(1.0, 1.0, 1.0), report.fields().get("spacing_mm"));
    assertEquals(source.sha256(), report.fields().get("sha256"));
    assertEquals(
        List.of(
            Map.of(
                "name",
                "block",
                "voxels",
                800L,
                "box",
                Map.of("x", List.of(3, 12), "y", List.of(3, 12), "z", List.of(3, 10))),
            Map.of("name", "none", "voxels", 0L)),
        report.fields().get("segments"));
  }

  @Test
  void workAndFaultsHaveTheirNames() {
    assertEquals(
        "{p50=2, p99=4, p99_9=4, max=4}",
        WorkFields.of(WorkPercentiles.of(new long[] {4, 1, 2, 3})).toString());
    FrameStatistics.Faults faults = new FrameStatistics.Faults(1, 2, 3, 4, 5, 6, 7, 8);
    assertEquals(
        "{held=1, not_finite=2, bad_times=4, silences=5, clock_jumps=6, force_not_finite=7,"
            + " unreached=8}",
        FaultFields.of(faults).toString());
    assertEquals(3L, FaultFields.ofTool(faults).get("bad_orientations"));
  }

  @Test
  void theNearestApproachToAProtectedSegmentIsReportedWithItsTime() {
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(16, 16, 16);
    BitCube bits = new BitCube(16, 16, 16);
    bits.set(8, 8, 8);
    SegmentedVolume volume = new SegmentedVolume(grid, List.of(new Segment("nerve", bits, 0)));
    ContactScene plain = new ContactScene(volume, ContactSettings.standard());
    Report report = new Report("touch", Optional.empty(), List.of());
    ProtectedFields.put(report, plain, frame -> 0.001 * frame);
    assertFalse(report.fields().containsKey("protected"));
    ContactSettings settings =
        ContactSettings.builder(SolverKind.SMOOTH).protect(Map.of("nerve", 1.5)).build();
    ContactScene scene = new ContactScene(volume, settings);
    ProtectedFields.put(report, scene, frame -> 0.001 * frame);
    assertEquals("[{segment=nerve, margin_mm=1.5}]", "" + report.fields().get("protected"));
    scene.approaches().get(0).notePoint(new Vec3(8.5, 8.5, 3), 41);
    scene.approaches().get(0).notePoint(new Vec3(8.5, 8.5, 4), 42);
    scene.approaches().get(0).notePoint(new Vec3(8.5, 8.5, 3.5), 43);
    ProtectedFields.put(report, scene, frame -> 0.001 * frame);
    Map<?, ?> field = (Map<?, ?>) ((List<?>) report.fields().get("protected")).get(0);
    assertEquals(42L, field.get("nearest_frame"));
    assertEquals(0.042, field.get("nearest_s"));
    assertTrue((double) field.get("nearest_mm") > 3 && (double) field.get("nearest_mm") < 4.6);
  }
}
