package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.platform.JawLabels;

/** Tests the surface files of {@code render}: one for all segments, or one for each. */
class SurfaceExportTest {
  @TempDir private Path folder;

  @Test
  void anObjFileHasAGroupForEachSegmentAndItsColoursBesideIt() throws IOException {
    Path obj = folder.resolve("head.obj");
    CommandRun run = CommandRun.of("render", "--phantom", "head:32", "--out", obj).mustSucceed();
    List<String> lines = Files.readAllLines(obj);
    assertEquals("# Palpate surface, mm", lines.get(0));
    assertEquals("mtllib head.mtl", lines.get(1));
    long groups = lines.stream().filter(line -> line.startsWith("g ")).count();
    assertTrue(groups > 1, "groups: " + groups);
    long colours =
        Files.readAllLines(folder.resolve("head.mtl")).stream()
            .filter(line -> line.startsWith("newmtl "))
            .count();
    assertEquals(groups, colours);
    assertTrue(run.out().contains("triangles of " + groups + " segments, in mm"), run.out());
  }

  @Test
  void eachSegmentHasAFileOfItsOwnIfAsked() throws IOException {
    Path volume = twoLabels("right-anterior-superior");
    CommandRun run =
        CommandRun.of("render", "--volume", volume, "--out", folder.resolve("a.stl"), "--separate")
            .mustSucceed();
    assertEquals(2, run.out().lines().filter(line -> line.startsWith("written: ")).count());
    try (Stream<Path> files = Files.list(folder)) {
      List<String> names =
          files
              .map(f -> f.getFileName().toString())
              .filter(f -> f.endsWith("stl"))
              .sorted()
              .toList();
      assertEquals(List.of("a-lower_jaw.stl", "a-upper_jaw.stl"), names);
    }
  }

  @ParameterizedTest
  @CsvSource({
    "left-posterior-superior, LPS, 20",
    "right-anterior-superior, RAS, 20",
    "left-anterior-superior, LPS, -20",
  })
  void theHeaderStatesTheSpaceOfThePositions(String space, String stated, double sign)
      throws IOException {
    Path stl = folder.resolve("a.stl");
    CommandRun run =
        CommandRun.of("render", "--volume", twoLabels(space), "--out", stl).mustSucceed();
    assertTrue(run.out().contains("SPACE=" + stated), run.out());
    byte[] bytes = Files.readAllBytes(stl);
    String header = new String(bytes, 0, 80, StandardCharsets.US_ASCII).replace("\0", "");
    assertEquals("Palpate surface, mm; SPACE=" + stated, header);
    float y = java.nio.ByteBuffer.wrap(bytes).order(java.nio.ByteOrder.LITTLE_ENDIAN).getFloat(100);
    assertEquals(Math.signum(sign), Math.signum(y), "y of the first corner: " + y);
    assertTrue(Math.abs(y) > 15 && Math.abs(y) < 30, "y of the first corner: " + y);
  }

  @Test
  void aPictureIsNotSeparated() {
    assertTrue(
        CommandRun.of("render", "--out", folder.resolve("a.png"), "--separate")
            .mustRefuse()
            .contains("a picture shows all segments"));
  }

  @Test
  void aSegmentThatTheFileListsWithoutAVoxelIsNamed() throws IOException {
    String out =
        CommandRun.of("info", "--volume", twoLabels("left-posterior-superior")).mustSucceed().out();
    assertTrue(out.contains("hyoid: no voxel"), out);
  }

  /** Writes two labels of 8x8x8 voxels, and a third segment that has none. */
  private Path twoLabels(String space) throws IOException {
    String third =
        """
        Segment2_ID:=S3
        Segment2_Name:=hyoid
        Segment2_LabelValue:=2
        """;
    Path file = folder.resolve("jaws.seg.nrrd");
    return JawLabels.write(file, 8, space, "(1,0,0) (0,1,0) (0,0,1)", third);
  }
}
