package org.palpate.io.nrrd;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.Scans;

class MalformedNrrdTest {
  private static final String GOOD =
      """
      NRRD0004
      type: uint8
      dimension: 3
      sizes: 2 3 4
      space: lps
      space directions: (1,0,0) (0,1,0) (0,0,2)
      space origin: (0,0,0)
      encoding: raw
      """;

  private static final long MAX_ALLOCATED_BYTES = 4_000_000;

  @TempDir Path folder;

  @Test
  void readsTheUnchangedHeader() throws Exception {
    VolumeReader reader = VolumeFiles.open(file("good.nrrd", GOOD, 24), ReadOptions.defaults());
    int[] slices = {0};
    reader.read((k, slice) -> slices[0]++);
    assertEquals(4, slices[0]);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "sizes: 2 3 4|sizes: 10000 10000 10000",
        "sizes: 2 3 4|sizes: 2 3 5",
        "sizes: 2 3 4|sizes: 2 3",
        "sizes: 2 3 4|sizes: 2 0 4",
        "sizes: 2 3 4|sizes: 2 -3 -4",
        "sizes: 2 3 4|sizes: 2 3 2147483648",
        "sizes: 2 3 4|sizes: 2147483647 2147483647 2147483647",
        "sizes: 2 3 4|sizes: 4294967296 4294967296 1",
        "dimension: 3|dimension: 4",
        "dimension: 3|dimension: 1000000000",
        "dimension: 3|dimension: -1",
        "type: uint8|type: block",
        "type: uint8|type: double",
        "type: uint8|type: int16",
        "encoding: raw|encoding: gzip",
        "encoding: raw|encoding: bzip2",
        "encoding: raw|encoding: hex",
        "encoding: raw|encoding: zip",
        "encoding: raw|encoding: raw\nbyte skip: -5",
        "encoding: raw|encoding: raw\nbyte skip: 9223372036854775807",
        "encoding: raw|encoding: raw\nline skip: 9223372036854775807",
        "encoding: raw|encoding: raw\ndata file: ../secret.raw",
        "encoding: raw|encoding: raw\ndata file: sub/../../secret.raw",
        "encoding: raw|encoding: raw\ndata file: sub\\..\\..\\secret.raw",
        "encoding: raw|encoding: raw\ndata file: /etc/passwd",
        "encoding: raw|encoding: raw\ndata file: C:\\secret.raw",
        "encoding: raw|encoding: raw\ndata file: absent.raw",
        "encoding: raw|encoding: raw\ndata file: bad.nrrd",
        "encoding: raw|encoding: raw\ndata file: LIST",
        "encoding: raw|encoding: raw\ndata file: a%09999999d.raw 1 2 1",
        "encoding: raw|encoding: raw\ndata file: a%d.raw 1 2000000000 1",
        "encoding: raw|encoding: raw\ndata file: a%s%n.raw 1 2 1",
        "(0,0,2)|(0,0,NaN)",
        "(0,0,2)|(0,0,inf)",
        "(0,0,2)|(0,0,0)",
        "(0,0,2)|(0,1,2)",
        "(0,0,2)|(0,2)",
        "(0,0,2)|",
        "(0,0,2)|none",
        "origin: (0,0,0)|origin: (NaN,0,0)",
        "space: lps|space: elsewhere",
        "space: lps|no field",
        "space: lps|type: uint8",
        "NRRD0004|NRRD0009",
      })
  void refusesAWrongHeaderInOneLineAndAllocatesLittle(String change) throws Exception {
    String[] parts = change.split("\\|", -1);
    assertTrue(GOOD.contains(parts[0]), parts[0]);
    Path file = file("bad.nrrd", GOOD.replace(parts[0], parts[1]), 24);
    assertThrows(VolumeFormatException.class, () -> openAndRead(file)); // loads classes
    long before = allocatedBytes();
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> openAndRead(file));
    assertTrue(
        allocatedBytes() - before < MAX_ALLOCATED_BYTES,
        "allocated " + (allocatedBytes() - before));
    assertEquals(1, refused.getMessage().lines().count());
    assertTrue(refused.getMessage().split(": ", -1).length >= 3, refused.getMessage());
  }

  @Test
  @DisabledOnOs(value = OS.WINDOWS, disabledReason = "skipped: links need a right there")
  void aLinkOutOfTheFolderIsRefused() throws Exception {
    Path inside = Files.createDirectory(folder.resolve("inside"));
    Path secret = Files.write(folder.resolve("secret.raw"), new byte[24]);
    Files.createSymbolicLink(inside.resolve("a.raw"), secret);
    Path header = Files.writeString(inside.resolve("a.nhdr"), GOOD + "data file: a.raw\n");
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> openAndRead(header));
    assertTrue(refused.getMessage().contains("outside its folder"), refused.getMessage());
  }

  @Test
  void headersThatNameEachOtherAreRefused() throws Exception {
    Files.writeString(folder.resolve("a.nhdr"), GOOD + "data file: b.nhdr\n");
    Files.writeString(folder.resolve("b.nhdr"), GOOD + "data file: a.nhdr\n");
    assertThrows(VolumeFormatException.class, () -> openAndRead(folder.resolve("a.nhdr")));
  }

  @Test
  void aHeaderLineOfMegabytesIsRefused() throws Exception {
    Path file = file("long.nrrd", GOOD + "#" + "x".repeat(3_000_000) + "\n", 24);
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> openAndRead(file));
    assertTrue(refused.getMessage().contains("no end"), refused.getMessage());
  }

  @Test
  void inflatesNoMoreThanTheSizesPromise() throws Exception {
    ByteArrayOutputStream bomb = new ByteArrayOutputStream();
    try (GZIPOutputStream gzip = new GZIPOutputStream(bomb)) {
      for (int n = 0; n < 100; n++) {
        gzip.write(new byte[1_000_000]);
      }
    }
    Path file = folder.resolve("bomb.nrrd");
    Files.writeString(file, GOOD.replace("raw", "gzip") + "\n");
    Files.write(file, bomb.toByteArray(), java.nio.file.StandardOpenOption.APPEND);
    long before = allocatedBytes();
    openAndRead(file);
    assertTrue(allocatedBytes() - before < MAX_ALLOCATED_BYTES);
    // the search for data from the end is bounded too
    Path fromEnd = folder.resolve("end.nrrd");
    Files.writeString(fromEnd, GOOD.replace("raw", "gzip") + "byte skip: -1\n\n");
    Files.write(fromEnd, bomb.toByteArray(), java.nio.file.StandardOpenOption.APPEND);
    assertThrows(VolumeFormatException.class, () -> openAndRead(fromEnd));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "formats/malformed/BallBinary30x30x30_byteskip_minus_five.nhdr",
        "formats/malformed/BallBinary30x30x30_nifti.nhdr"
      })
  void theMalformedSamplesAreRefused(String name) {
    Path file = Scans.file(name);
    assertThrows(VolumeFormatException.class, () -> openAndRead(file));
  }

  @Test
  void emptyMissingAndUnknownFilesAreRefused() throws Exception {
    Path empty = Files.createFile(folder.resolve("empty.nrrd"));
    assertThrows(VolumeFormatException.class, () -> openAndRead(empty));
    assertThrows(VolumeFormatException.class, () -> openAndRead(folder.resolve("absent.nrrd")));
    assertThrows(VolumeFormatException.class, () -> openAndRead(folder));
    Path text = Files.writeString(folder.resolve("a.txt"), "hello");
    assertThrows(VolumeFormatException.class, () -> openAndRead(text));
  }

  private Path file(String name, String header, int dataBytes) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    bytes.write((header + "\n").getBytes(StandardCharsets.UTF_8));
    bytes.write(new byte[dataBytes]);
    return Files.write(folder.resolve(name), bytes.toByteArray());
  }

  private static void openAndRead(Path file) throws VolumeFormatException {
    VolumeFiles.open(file, ReadOptions.defaults()).read((k, slice) -> {});
  }

  private static long allocatedBytes() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    return threads.getThreadAllocatedBytes(Thread.currentThread().getId());
  }
}
