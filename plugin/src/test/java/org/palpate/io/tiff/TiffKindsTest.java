package org.palpate.io.tiff;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.github.luben.zstd.Zstd;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Reads pixels of every kind from files of one page that are put together byte by byte. */
class TiffKindsTest {
  private static final int WIDTH = 256;
  private static final int HEIGHT = 257;
  private static final int BITS = 258;
  private static final int COMPRESSION = 259;
  private static final int PHOTOMETRIC = 262;
  private static final int DESCRIPTION = 270;
  private static final int ORIENTATION = 274;
  private static final int SAMPLES = 277;
  private static final int PLANAR = 284;
  private static final int COLOUR_MAP = 320;
  private static final int FORMAT = 339;
  private static final int IMAGE_DEPTH = 32997;
  private static final int METAMORPH_PLANES = 33629;

  @TempDir Path folder;

  /** A page: its tags, of one value each or as words, and its pixels. */
  private final Map<Integer, int[]> tags = new TreeMap<>();

  @Test
  void twelveBitsAreReadWithRowsThatEndWithAByte() throws Exception {
    page(3, 2, 12, 1);
    byte[] pixels = bytes(0x00, 0x1f, 0xff, 0x80, 0x00, 0xab, 0xc1, 0x23, 0x45, 0x60);
    assertArrayEquals(new double[] {1, 0xfff, 0x800, 0xabc, 0x123, 0x456}, values(pixels));
  }

  @Test
  void halfFloatsAreReadExactly() throws Exception {
    page(3, 2, 16, 1);
    tags.put(FORMAT, new int[] {3});
    byte[] pixels = shorts(0x3e00, 0xc000, 0x7bff, 0x0001, 0x8400, 0x7c00);
    assertArrayEquals(
        new double[] {1.5, -2, 65504, 0x1p-24, -0x1p-14, Double.POSITIVE_INFINITY}, values(pixels));
  }

  @Test
  void sixteenBitsWithWhiteAsZeroAreInverted() throws Exception {
    page(2, 1, 16, 0);
    assertArrayEquals(new double[] {65535, 0}, values(shorts(0, 65535)));
  }

  @Test
  void coloursAreReadAsLuminanceInEitherArrangement() throws Exception {
    page(2, 1, 8, 2);
    tags.put(SAMPLES, new int[] {3});
    double[] expected = {124, 255}; // (299 * 200 + 587 * 100 + 114 * 50) / 1000, rounded
    assertArrayEquals(expected, values(bytes(200, 100, 50, 255, 255, 255)));
    assertTrue(notes().contains("luminance"), notes());
    tags.put(PLANAR, new int[] {2});
    assertArrayEquals(expected, values(bytes(200, 255, 100, 255, 50, 255)));
  }

  @Test
  void theOpacityOfGreyPixelsIsLeftOut() throws Exception {
    page(2, 1, 8, 1);
    tags.put(SAMPLES, new int[] {2});
    assertArrayEquals(new double[] {7, 9}, values(bytes(7, 255, 9, 128)));
    assertTrue(notes().contains("opacity"), notes());
  }

  @Test
  void aPaletteOfGreysGivesItsValuesAndOneOfColoursItsIndices() throws Exception {
    page(4, 1, 2, 3);
    int[] greys = {65535, 0x8080, 0x1010, 0};
    tags.put(COLOUR_MAP, map(greys, greys));
    assertArrayEquals(new double[] {255, 128, 16, 0}, values(bytes(0b00011011)));
    tags.put(COLOUR_MAP, map(greys, new int[] {0, 1, 2, 3}));
    assertArrayEquals(new double[] {0, 1, 2, 3}, values(bytes(0b00011011)));
    assertTrue(notes().contains("indices of the file's palette"), notes());
  }

  @Test
  void aPageOfSeveralPlanesIsNotTakenForOneSlice() throws Exception {
    for (int tag : new int[] {IMAGE_DEPTH, METAMORPH_PLANES}) {
      page(2, 1, 8, 1);
      tags.put(tag, tag == IMAGE_DEPTH ? new int[] {5} : new int[] {1, 1, 1, 1, 1});
      Path file = write(bytes(1, 2, 3, 4, 5, 6, 7, 8, 9, 10));
      String message =
          assertThrows(
                  VolumeFormatException.class, () -> TiffReader.open(file, ReadOptions.defaults()))
              .getMessage();
      assertTrue(message.contains("the page holds 5 planes"), message);
    }
  }

  @Test
  void anOrientationThatIsNotAppliedIsNoted() throws Exception {
    page(2, 1, 8, 1);
    tags.put(ORIENTATION, new int[] {2});
    assertArrayEquals(new double[] {7, 9}, values(bytes(7, 9)));
    assertTrue(notes().contains("Orientation 2"), notes());
  }

  @ParameterizedTest
  @CsvSource({"7, JPEG", "34712, JPEG 2000", "4, CCITT fax", "777, kind 777"})
  void anotherCompressionIsRefusedByName(int code, String name) throws Exception {
    page(2, 1, 8, 1);
    tags.put(COMPRESSION, new int[] {code});
    Path file = write(bytes(1, 2));
    String message =
        assertThrows(
                VolumeFormatException.class, () -> TiffReader.open(file, ReadOptions.defaults()))
            .getMessage();
    assertTrue(message.contains("the compression is ") && message.contains(name), message);
    assertTrue(message.contains("tiffcp -c lzw"), message);
  }

  @Test
  void pixelsThatZstdCompressedAreReadAndDamagedOnesAreRefused() throws Exception {
    page(3, 2, 16, 1);
    tags.put(COMPRESSION, new int[] {50000});
    byte[] stored = Zstd.compress(shorts(1, 2, 3, 500, 60000, 7));
    assertArrayEquals(new double[] {1, 2, 3, 500, 60000, 7}, values(stored));
    for (int length : new int[] {0, 3, stored.length - 1}) {
      assertTrue(damage(Arrays.copyOf(stored, length)).contains("slice 1 is damaged"));
    }
    stored[0] ^= 1;
    assertTrue(damage(stored).contains("slice 1 is damaged"));
  }

  private String damage(byte[] pixels) {
    return assertThrows(VolumeFormatException.class, () -> values(pixels)).getMessage();
  }

  @ParameterizedTest
  @CsvSource({"0, 0, 2", "1, 1, 3", "2, 4, 6", "3, 5, 7"})
  void aStackThatImagejStoredBehindOnePageHasChannelsAndTimes(int step, int first, int second)
      throws Exception {
    page(1, 1, 8, 1);
    describe("ImageJ=1.54p\nimages=8\nchannels=2\nslices=2\nframes=2\nunit=mm\nspacing=3\n");
    Path file = write(bytes(0, 1, 2, 3, 4, 5, 6, 7));
    VolumeReader reader = TiffReader.open(file, ReadOptions.defaults().withTimeStep(step));
    assertEquals(2, reader.header().grid().sizeZ());
    double[] values = new double[2];
    reader.read((k, slice) -> values[k] = slice.value(0));
    assertArrayEquals(new double[] {first, second}, values);
  }

  @Test
  void aDescriptionThatPromisesMorePagesIsRefused() throws Exception {
    page(1, 1, 8, 1);
    tags.put(COMPRESSION, new int[] {5});
    describe("ImageJ=1.54p\nimages=8\nslices=8\n");
    Path file = write(bytes(0x80, 0x01, 0x40, 0x40));
    String message =
        assertThrows(
                VolumeFormatException.class, () -> TiffReader.open(file, ReadOptions.defaults()))
            .getMessage();
    assertTrue(message.contains("promises 8 images but the file has 1 pages"), message);
  }

  private void page(int width, int height, int bits, int photometric) {
    tags.put(WIDTH, new int[] {width});
    tags.put(HEIGHT, new int[] {height});
    tags.put(BITS, new int[] {bits});
    tags.put(PHOTOMETRIC, new int[] {photometric});
  }

  private void describe(String text) {
    byte[] bytes = (text + "\0").getBytes(StandardCharsets.UTF_8);
    int[] numbers = new int[bytes.length];
    for (int n = 0; n < bytes.length; n++) {
      numbers[n] = bytes[n];
    }
    tags.put(DESCRIPTION, numbers);
  }

  private static int[] map(int[] red, int[] others) {
    int[] map = new int[3 * red.length];
    System.arraycopy(red, 0, map, 0, red.length);
    System.arraycopy(others, 0, map, red.length, red.length);
    System.arraycopy(others, 0, map, 2 * red.length, red.length);
    return map;
  }

  private double[] values(byte[] pixels) throws IOException {
    VolumeReader reader = TiffReader.open(write(pixels), ReadOptions.defaults());
    double[] values = new double[reader.header().grid().sizeX() * reader.header().grid().sizeY()];
    reader.read(
        (k, slice) -> {
          for (int n = 0; n < values.length; n++) {
            values[n] = slice.value(n);
            assertTrue(
                values[n] >= reader.header().values().low()
                    && values[n] <= reader.header().values().high(),
                "outside the stated range: " + values[n]);
          }
        });
    return values;
  }

  private String notes() throws IOException {
    return TiffReader.open(folder.resolve("a.tif"), ReadOptions.defaults())
        .header()
        .notes()
        .toString();
  }

  /** Writes the page in big-endian order: the directory, the values of long tags, the pixels. */
  private Path write(byte[] pixels) throws IOException {
    int planes = tags.containsKey(PLANAR) ? 3 : 1;
    int[] offsets = new int[planes];
    int[] counts = new int[planes];
    Arrays.fill(counts, pixels.length / planes);
    tags.put(273, offsets);
    tags.put(279, counts);
    int begin = 8 + 2 + 12 * tags.size() + 4;
    for (int[] numbers : tags.values()) {
      begin += numbers.length > 1 ? 4 * numbers.length : 0;
    }
    for (int plane = 0; plane < planes; plane++) {
      offsets[plane] = begin + plane * pixels.length / planes;
    }
    ByteBuffer out = ByteBuffer.allocate(begin + pixels.length).order(ByteOrder.BIG_ENDIAN);
    out.put("MM".getBytes(StandardCharsets.US_ASCII)).putShort((short) 42).putInt(8);
    out.putShort((short) tags.size());
    int after = 8 + 2 + 12 * tags.size() + 4;
    for (Map.Entry<Integer, int[]> tag : tags.entrySet()) {
      int[] numbers = tag.getValue();
      out.putShort(tag.getKey().shortValue()).putShort((short) 4).putInt(numbers.length);
      out.putInt(numbers.length > 1 ? after : numbers[0]);
      for (int n = 0; numbers.length > 1 && n < numbers.length; n++, after += 4) {
        out.putInt(after, numbers[n]);
      }
    }
    System.arraycopy(pixels, 0, out.array(), begin, pixels.length);
    return Files.write(folder.resolve("a.tif"), out.array());
  }

  private static byte[] bytes(int... values) {
    byte[] bytes = new byte[values.length];
    for (int n = 0; n < values.length; n++) {
      bytes[n] = (byte) values[n];
    }
    return bytes;
  }

  private static byte[] shorts(int... values) {
    ByteBuffer bytes = ByteBuffer.allocate(2 * values.length);
    for (int value : values) {
      bytes.putShort((short) value);
    }
    return bytes.array();
  }
}
