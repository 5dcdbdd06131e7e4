package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

/** The parts from which readers make sense of a header. */
class HeaderPartsTest {
  private static final Path FILE = Path.of("scan.nrrd");

  private static String refusal(org.junit.jupiter.api.function.Executable call) {
    return assertThrows(VolumeFormatException.class, call).getMessage();
  }

  private static HeaderLineReader lines(String text) {
    return new HeaderLineReader(
        new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)), FILE);
  }

  @Test
  void linesEndInAnyWayAndTheirBytesAreCounted() throws IOException {
    HeaderLineReader lines = lines("a: b\r\n\n\u00e9\nlast");
    assertEquals("a: b", lines.next());
    assertEquals(6, lines.bytesRead());
    assertEquals("", lines.next());
    assertEquals("\u00e9", lines.next());
    assertEquals(10, lines.bytesRead());
    assertEquals("last", lines.next());
    assertEquals(14, lines.bytesRead());
    assertNull(lines.next());
    assertEquals("x".repeat(5000), lines("x".repeat(5000) + "\n").next());
  }

  @Test
  void aLineWithoutAnEndIsRefused() {
    assertEquals(
        "a line of the header has no end: scan.nrrd: export the file again; its header is damaged",
        refusal(() -> lines("x".repeat((1 << 20) + 1)).next()));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "slice.raw|slice.raw",
        "slice 1 2 3|slice 1 2 3",
        "s%d.raw 8 10 1|s8.raw,s9.raw,s10.raw",
        "s%03d.raw 1 3 2|s001.raw,s003.raw",
        "s%2u.raw 3 1 -1|s 3.raw,s 2.raw,s 1.raw",
        "s%d.raw -1 1 1 3|s-1.raw,s0.raw,s1.raw"
      })
  void aPatternStandsForItsFiles(String value, String names) throws VolumeFormatException {
    assertEquals(List.of(names.split(",", -1)), FilePattern.names(FILE, value));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      quoteCharacter = '"',
      value = {
        "s%d%d.raw 1 2 1|the pattern 's%d%d.raw' needs exactly one number like %03d",
        "s%s.raw 1 2 1|the pattern 's%s.raw' needs exactly one number like %03d",
        "s%12d.raw 1 2 1|the pattern 's%12d.raw' needs exactly one number like %03d",
        "s%d 1 2 0|the numbers of its file pattern give no list of files",
        "s%d 2 1 1|the numbers of its file pattern give no list of files",
        "s%d 1 100001 1|the numbers of its file pattern give no list of files",
        "s%d 1 x 1|'x' in the file pattern is no integer",
        "s%d 1 9999999999 1|'9999999999' in the file pattern is no integer"
      })
  void aPatternWithoutFilesIsRefused(String value, String what) {
    assertEquals(
        what + ": scan.nrrd: list the names of the data files instead (LIST)",
        refusal(() -> FilePattern.names(FILE, value)));
  }

  @Test
  void aGridHasTheLengthsAndDirectionsOfItsSteps() throws VolumeFormatException {
    Vec3[] steps = {new Vec3(0, 0.5, 0), new Vec3(-2, 0, 0), new Vec3(0, 0, 3)};
    VoxelGrid grid = Grids.of(new int[] {2, 3, 4}, steps, new Vec3(1, 2, 3), FILE);
    assertEquals("(0.5, 2.0, 3.0)", grid.spacingMm().toString());
    Vec3 last = grid.gridToWorld(new Vec3(1.5, 2.5, 3.5), new Vec3());
    assertEquals(0, last.sub(new Vec3(1 - 4, 2 + 0.5, 3 + 9), last).length(), 1e-12);
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(0, Grids.stepMm(grid, axis).sub(steps[axis], new Vec3()).length(), 1e-12);
    }
    VoxelGrid plain = Grids.ofSpacing(new int[] {1, 1, 1}, new Vec3(2, 2, 2), FILE);
    assertEquals(0, plain.gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3()).length());
  }

  @Test
  void aGridThatCannotBeIsRefusedWithItsNumbers() {
    Vec3[] unit = Grids.steps(new Vec3(1, 1, 1));
    assertEquals(
        "the size is 2x0x4 voxels: scan.nrrd: write a volume with at least one voxel",
        refusal(() -> Grids.of(new int[] {2, 0, 4}, unit, new Vec3(), FILE)));
    assertEquals(
        "the size is 100000x100000x4 voxels, more than fit in any memory: scan.nrrd: crop or halve"
            + " the volume in the tool that wrote it",
        refusal(() -> Grids.of(new int[] {100_000, 100_000, 4}, unit, new Vec3(), FILE)));
    assertEquals(
        "the spacing along axis y is 0.0 mm: scan.nrrd: give the file spacings from 1e-12 to 1e12"
            + " mm in the tool that wrote it",
        refusal(() -> Grids.ofSpacing(new int[] {1, 1, 1}, new Vec3(1, 0, 1), FILE)));
    assertEquals(
        "the origin (0.0, NaN, 0.0) is not finite: scan.nrrd: export the file again with an origin",
        refusal(() -> Grids.of(new int[] {1, 1, 1}, unit, new Vec3(0, Double.NaN, 0), FILE)));
    Vec3[] sheared = {new Vec3(1, 0, 0), new Vec3(1, 1, 0), new Vec3(0, 0, 1)};
    assertEquals(
        "the axes are not at right angles (45.0, 90.0, 90.0 degrees): scan.nrrd: resample it onto a"
            + " rectangular grid in the tool that wrote it",
        refusal(() -> Grids.of(new int[] {1, 1, 1}, sheared, new Vec3(), FILE)));
    assertEquals(
        "the spacing along z is stated as -2: that axis runs backward",
        Grids.negativeSpacing(2, -2, Grids.RUNS_BACKWARD));
  }

  @Test
  void aStepIsChosenAmongSeveral() throws VolumeFormatException {
    List<String> notes = new ArrayList<>();
    ReadOptions none = ReadOptions.defaults();
    assertEquals(0, ReadOptionChecks.chosenStep(1, none, FILE, notes));
    assertEquals(0, ReadOptionChecks.chosenStep(1, none.withTimeStep(0), FILE, notes));
    assertEquals(List.of(), notes);
    assertEquals(2, ReadOptionChecks.chosenStep(3, none.withTimeStep(2), FILE, notes));
    assertEquals(List.of("step 2 of 3, counted from 0"), notes);
    assertEquals(
        "the file has 3 time steps or components: scan.nrrd: choose one with --time 0 to --time 2",
        refusal(() -> ReadOptionChecks.chosenStep(3, none, FILE, notes)));
    assertEquals(
        "the file has no step 3, only 0 to 2: scan.nrrd: choose one with --time 0 to --time 2",
        refusal(() -> ReadOptionChecks.chosenStep(3, none.withTimeStep(3), FILE, notes)));
    assertEquals(
        "the file has a single time step, no step 1: scan.nrrd: leave --time out",
        refusal(() -> ReadOptionChecks.chosenStep(1, none.withTimeStep(1), FILE, notes)));
    ReadOptionChecks.refuseSeriesOption(none, FILE);
    assertTrue(
        refusal(() -> ReadOptionChecks.refuseSeriesOption(none.withSeries("1"), FILE))
            .endsWith(": scan.nrrd: leave --series out"));
  }

  @ParameterizedTest
  @CsvSource({
    "UINT8, 1, 0, 0, 255, true",
    "UINT8, 2, -10, -10, 500, true",
    "UINT8, -1, 0, -255, 0, true",
    "UINT8, 0.5, 0, 0, 127.5, false",
    "UINT8, 1, 0.5, 0.5, 255.5, false",
    "UINT16, 65536, 0, 0, 4294901760, false",
    "INT64, 1, 0, -9223372036854775808, 9223372036854775808, false",
    "FLOAT32, 2, 1, -Infinity, Infinity, false"
  })
  void aScalingWidensTheRangeOfItsType(
      VoxelType type, double slope, double intercept, double low, double high, boolean integer) {
    assertEquals(new ValueRange(low, high, integer), new Scaling(slope, intercept).range(type));
  }

  @Test
  void namesAreOrderedAsPeopleDo() {
    List<String> sorted =
        Stream.of("s10.dcm", "s2.dcm", "S1.dcm", "s02.dcm", "a99", "s2", "t", "9", "10")
            .map(Path::of)
            .sorted(NaturalOrder.OF_FILE_NAMES)
            .map(Path::toString)
            .toList();
    assertEquals(
        List.of("9", "10", "a99", "S1.dcm", "s2", "s02.dcm", "s2.dcm", "s10.dcm", "t"), sorted);
  }

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void anAxisOfTimeDividesASliceIntoRuns(int position) {
    int[] runs = {1, 7, 35, 35};
    assertEquals(runs[position], new NonSpatialAxis(position, 3, 0).contiguousSamples(7, 5));
  }
}
