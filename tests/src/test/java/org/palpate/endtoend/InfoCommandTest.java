package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.testing.Scans;

class InfoCommandTest {
  @TempDir private Path folder;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "CThead/CThead_u16gz.nrrd | bone=>=1500 | 336108",
        "LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd | bone=>=200 | 2068115",
        "LIDC/LIDC-IDRI-0314_bone200_u8gz.nrrd | bone=nonzero | 2068115",
        "labels/HN-Atlas-labels.nrrd | all=nonzero | 972670",
        "labels/HN-Atlas-labels.nrrd | bones=label:9,10,11,12,13,14,15,16,17,21,22,23,24,25,26,27,"
            + "28,31,32,33,34,35,36 | 660896",
        "totalseg/example_seg_fast_force_split.nii.gz | all=nonzero | 345988",
        "labels/Skull.nrrd | skull=nonzero | 532633"
      })
  void countsTheVoxelsOfRealScans(String file, String segment, String voxels) throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--volume", Scans.file(file), "--segment", segment, "--report", report)
        .mustSucceed();
    assertEquals(voxels, FlatJson.read(report).get("/segments/0/voxels"));
  }

  @Test
  void reportsTheBoundsOfTheHeadsBone() throws IOException {
    CommandRun run =
        CommandRun.of(
                "info",
                "--volume",
                Scans.file("CThead/CThead_u16gz.nrrd"),
                "--segment",
                "bone=>=1500")
            .mustSucceed();
    assertTrue(run.out().contains("336,108 voxels, x 28-195, y 25-238, z 4-112"), run.out());
  }

  @Test
  void neverRefusesAVolumeWithoutASegment() {
    CommandRun run =
        CommandRun.of("info", "--volume", Scans.file("CThead/CThead_u16gz.nrrd")).mustSucceed();
    assertTrue(run.out().contains("--segment"), run.out());
  }

  @Test
  void makesASegmentOfEachLabel() throws IOException {
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--phantom", "head:64", "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("skull", json.get("/segments/0/name"));
    assertEquals("jaw", json.get("/segments/1/name"));
    assertEquals("skin", json.get("/segments/2/name"));
  }

  @Test
  void makesOneSegmentOfAMask() throws IOException {
    Path volume = TestFiles.nrrd(folder.resolve("mask.nrrd"), 20, v -> v[2] < 5 ? 255 : 0);
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--volume", volume, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("2000", json.get("/segments/0/voxels"));
    assertEquals(null, json.get("/segments/1/voxels"));
  }

  @Test
  void reportsTheVolumeWithItsChecksum() throws IOException, NoSuchAlgorithmException {
    Path volume = TestFiles.nrrd(folder.resolve("v.nrrd"), 20, v -> v[0] & 1);
    Path report = folder.resolve("r.json");
    CommandRun.of("info", "--volume", volume, "--report", report).mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    byte[] digest = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(volume));
    assertEquals(HexFormat.of().formatHex(digest), json.get("/sha256"));
    assertEquals("info", json.get("/command"));
    assertEquals("20", json.get("/sizes/0"));
    assertEquals("2.0", json.get("/spacing_mm/2"));
    assertTrue(json.containsKey("/version") && json.containsKey("/java"), json.toString());
  }

  @Test
  void readsRawFilesByTheirDescription() throws IOException {
    byte[] bytes = new byte[4 * 5 * 6 * 2];
    bytes[2 * 7] = 6; // 1536, big-endian
    Path raw = Files.write(folder.resolve("v.raw"), bytes);
    Path report = folder.resolve("r.json");
    CommandRun.of(
            "info",
            "--volume",
            raw,
            "--raw",
            "4x5x6:u16be:1,1,2",
            "--segment",
            "one=>=1500",
            "--report",
            report)
        .mustSucceed();
    Map<String, String> json = FlatJson.read(report);
    assertEquals("1", json.get("/segments/0/voxels"));
    assertEquals("3", json.get("/segments/0/box/x/0"));
    assertEquals("1", json.get("/segments/0/box/y/0"));
  }

  @Test
  void refusesEmptyTruncatedAndInconsistentFiles() throws IOException {
    byte[] whole = TestFiles.nrrdBytes(20, v -> v[0] & 1);
    String lie =
        "NRRD0004\ntype: double\ndimension: 3\nsizes: 10000 10000 10000\nencoding: raw\n\n";
    byte[][] bad = {
      {},
      "hello".getBytes(StandardCharsets.US_ASCII),
      Arrays.copyOf(whole, whole.length - 1),
      Arrays.copyOf(whole, 60),
      lie.getBytes(StandardCharsets.US_ASCII)
    };
    for (int n = 0; n < bad.length; n++) {
      Path file = Files.write(folder.resolve("bad" + n + ".nrrd"), bad[n]);
      CommandRun.of("info", "--volume", file).mustRefuse();
    }
  }

  @Test
  void refusesEveryMalformedSampleInOneLine() throws IOException {
    Path malformed = Scans.file("formats/malformed");
    try (var files = Files.list(malformed)) {
      files
          .filter(Files::isRegularFile)
          .filter(file -> !file.toString().matches(".*\\.(md|txt)"))
          .sorted()
          .forEach(file -> CommandRun.of("info", "--volume", file).mustRefuse());
    }
  }
}
