package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;

class BinaryDataTest {
  @TempDir private Path folder;

  private Path file(String name, int... bytes) throws IOException {
    byte[] content = new byte[bytes.length];
    for (int n = 0; n < bytes.length; n++) {
      content[n] = (byte) bytes[n];
    }
    return Files.write(folder.resolve(name), content);
  }

  private static BinaryData data(BinaryData.Start start, long byteCount, Path... files) {
    return new BinaryData(
        List.of(files), start, VoxelType.UINT8, ByteOrder.LITTLE_ENDIAN, Scaling.NONE, byteCount);
  }

  private static String read(BinaryData data, int count) throws IOException {
    data.requireFileLengths();
    VoxelSlice slice = new VoxelSlice(count, 1, true);
    try (SampleStream stream = data.open()) {
      stream.read(slice, 0, count);
    }
    return Arrays.toString(slice.integers());
  }

  @Test
  void dataFollowTheirOffsetOrAreTheLastBytes() throws IOException {
    Path file = file("a.raw", 9, 9, 1, 2, 3);
    assertEquals("[1, 2, 3]", read(data(new BinaryData.Start(2, false, false), 3, file), 3));
    assertEquals(
        "[2, 3]",
        read(data(new BinaryData.Start(BinaryData.Start.AT_END, false, false), 2, file), 2));
  }

  @Test
  void aStreamMayBeDeflatedOrGzippedOrInsideAGzip() throws IOException {
    byte[] values = {4, 5, 6, 7};
    ByteArrayOutputStream zlib = new ByteArrayOutputStream();
    zlib.write(new byte[] {9, 9});
    try (OutputStream out = new DeflaterOutputStream(zlib)) {
      out.write(values);
    }
    ByteArrayOutputStream gzip = new ByteArrayOutputStream();
    gzip.write(new byte[] {9, 9});
    try (OutputStream out = new GZIPOutputStream(gzip)) {
      out.write(values);
    }
    ByteArrayOutputStream whole = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(whole)) {
      out.write(new byte[] {9, 9});
      out.write(values);
    }
    BinaryData.Start deflated = new BinaryData.Start(2, true, false);
    Path a = Files.write(folder.resolve("a"), zlib.toByteArray());
    Path b = Files.write(folder.resolve("b"), gzip.toByteArray());
    Path c = Files.write(folder.resolve("c"), whole.toByteArray());
    assertEquals("[4, 5, 6, 7]", read(data(deflated, 4, a), 4));
    assertEquals("[4, 5, 6, 7]", read(data(deflated, 4, b), 4));
    assertEquals("[4, 5, 6, 7]", read(data(new BinaryData.Start(2, false, true), 4, c), 4));
  }

  @Test
  void severalFilesGiveTheSameNumberOfBytesEach() throws IOException {
    Path a = file("a", 9, 1, 2, 8, 8);
    Path b = file("b", 9, 3, 4);
    BinaryData.Start start = new BinaryData.Start(1, false, false);
    assertEquals("[1, 2, 3, 4]", read(data(start, 4, a, b), 4));
    VolumeFormatException odd =
        assertThrows(VolumeFormatException.class, () -> data(start, 5, a, b).requireFileLengths());
    assertEquals(
        "5 bytes of data cannot be split evenly over 2 files: "
            + a
            + ": correct the sizes or the list of files",
        odd.getMessage());
    VolumeFormatException tooShort =
        assertThrows(VolumeFormatException.class, () -> data(start, 6, a, b).requireFileLengths());
    assertEquals(
        "the header promises 3 bytes of data but the file has 2: "
            + b
            + ": copy the file again; if that does not help, export it again",
        tooShort.getMessage());
  }

  @Test
  void aCompressedFileIsRefusedOnlyIfNothingCouldInflateSoFar() throws IOException {
    Path file = file("z", 1, 2, 3, 4);
    BinaryData.Start start = new BinaryData.Start(0, true, false);
    data(start, 4L * BinaryData.MAX_DEFLATE_RATIO, file).requireFileLengths();
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class,
            () -> data(start, 4L * BinaryData.MAX_DEFLATE_RATIO + 1, file).requireFileLengths());
    assertEquals(
        "the header promises 4,129 bytes of data but the file has 4 (compressed): "
            + file
            + ": copy the file again; if that does not help, export it again",
        refusal.getMessage());
    BinaryData.Start inside = new BinaryData.Start(100, false, true);
    data(inside, 4L * BinaryData.MAX_DEFLATE_RATIO - 100, file).requireFileLengths();
    assertThrows(
        VolumeFormatException.class,
        () -> data(inside, 4L * BinaryData.MAX_DEFLATE_RATIO - 99, file).requireFileLengths());
  }

  @Test
  void filesAreJoinedByteByByte() throws IOException {
    Path a = file("a", 1, 2, 3);
    Path b = file("b");
    Path c = file("c", 255);
    List<Path> files = List.of(a, b, c);
    try (ConcatenatedInputStream all =
        new ConcatenatedInputStream(files, Files::newInputStream, Long.MAX_VALUE)) {
      assertEquals(1, all.read());
      assertEquals("[2, 3, -1]", Arrays.toString(all.readAllBytes()));
      assertEquals(-1, all.read());
    }
    ConcatenatedInputStream two =
        new ConcatenatedInputStream(List.of(a, c), Files::newInputStream, 2);
    assertEquals("[1, 2]", Arrays.toString(two.readNBytes(2)));
    assertEquals(255, two.read());
    assertEquals(
        "a data file is too short", assertThrows(EOFException.class, two::read).getMessage());
    two.close();
  }

  @Test
  void gzipIsKnownByItsFirstTwoBytes() {
    assertEquals(true, BinaryData.isGzip(new byte[] {0x1f, (byte) 0x8b}));
    assertEquals(false, BinaryData.isGzip(new byte[] {0x1f}));
    assertEquals(false, BinaryData.isGzip(new byte[] {0x1f, 0x0b}));
    assertEquals(false, BinaryData.isGzip(new byte[] {0x1e, (byte) 0x8b}));
  }
}
