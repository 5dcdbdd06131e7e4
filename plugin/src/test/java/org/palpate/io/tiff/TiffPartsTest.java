package org.palpate.io.tiff;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.format.Scaling;
import org.palpate.testing.Seeds;

/** The parts from which a TIFF is understood. */
class TiffPartsTest {
  private static final long SEED = Seeds.seed();

  private final SplittableRandom random = new SplittableRandom(SEED);

  @Test
  void aFractionReadsBackAsItsSize() {
    for (int round = 0; round < 20_000; round++) {
      int bottom = 1 + random.nextInt(30_000);
      int top = 1 + random.nextInt(30_000);
      double size = 1 / ((double) bottom / top);
      int[] found = Fraction.reciprocalOf(size);
      assertEquals(size, 1 / ((double) found[0] / found[1]), "seed=" + SEED + " " + top);
      assertTrue(found[1] <= top, "none simpler than " + top + "/" + bottom);
    }
    assertArrayEquals(new int[] {2, 1}, Fraction.reciprocalOf(0.5));
    assertArrayEquals(new int[] {1, 3}, Fraction.reciprocalOf(3));
  }

  @ParameterizedTest
  @ValueSource(doubles = {Math.PI, 1e-7, 123456.789, 1e9, 1e-9})
  void aSizeThatNoFractionHasIsNearlyRight(double size) {
    int[] found = Fraction.reciprocalOf(size);
    assertTrue(found[0] > 0 && found[1] > 0);
    double again = (double) found[1] / found[0];
    assertEquals(size, again, Math.max(1e-9 * size, 1.0 / Integer.MAX_VALUE));
  }

  @Test
  void everyHalfFloatHasTheValueThatItsBitsSay() {
    for (int bits = 0; bits < 1 << 16; bits++) {
      int exponent = bits >> 10 & 31;
      int mantissa = bits & 1023;
      double magnitude =
          exponent == 0
              ? Math.scalb((double) mantissa, -24)
              : exponent == 31
                  ? mantissa == 0 ? Double.POSITIVE_INFINITY : Double.NaN
                  : Math.scalb(1024.0 + mantissa, exponent - 25);
      double expected = (bits & 0x8000) == 0 ? magnitude : -magnitude;
      assertEquals((float) expected, RowUnpacker.halfToFloat((short) bits), "bits " + bits);
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {0, -1})
  void aPixelWithoutSamplesCannotBeRead(int samples) {
    TiffPixels pixels = new TiffPixels(samples, 8, 1, TiffPixels.BLACK_IS_ZERO, false, false);
    assertEquals("a pixel has " + samples + " samples", pixels.fault());
  }

  @Test
  void theBitsOfAByteAreReversed() {
    byte[] bytes = {0b00000001, 0b01101000, -1, 0};
    RowUnpacker.reverseBits(bytes);
    assertArrayEquals(new byte[] {-128, 0b00010110, -1, 0}, bytes);
  }

  @ParameterizedTest
  @CsvSource({
    "1, 1, true",
    "1, 3, true",
    "2, 1, true",
    "2, 3, false",
    "4, 1, true",
    "4, 2, false",
    "8, 1, true"
  })
  void whatAHorizontalPredictorTookAwayIsAdded(int size, int stride, boolean big) {
    ByteOrder order = big ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    int count = 24;
    byte[] original = randomBytes(5 + count * size);
    byte[] predicted = original.clone();
    ByteBuffer from = ByteBuffer.wrap(original).order(order);
    ByteBuffer to = ByteBuffer.wrap(predicted).order(order);
    for (int n = stride; n < count; n++) {
      int at = 5 + n * size;
      int left = at - stride * size;
      switch (size) {
        case 1 -> to.put(at, (byte) (from.get(at) - from.get(left)));
        case 2 -> to.putShort(at, (short) (from.getShort(at) - from.getShort(left)));
        case 4 -> to.putInt(at, from.getInt(at) - from.getInt(left));
        default -> to.putLong(at, from.getLong(at) - from.getLong(left));
      }
    }
    new TiffPredictor(TiffPredictor.HORIZONTAL, order).undo(predicted, 5, count, size, stride);
    assertArrayEquals(original, predicted, "seed=" + SEED);
  }

  private byte[] randomBytes(int count) {
    byte[] bytes = new byte[count];
    random.nextBytes(bytes);
    return bytes;
  }

  @ParameterizedTest
  @CsvSource({"2, true", "4, true", "4, false", "8, false"})
  void whatAFloatingPointPredictorDividedIsGathered(int size, boolean big) {
    ByteOrder order = big ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN;
    TiffPredictor predictor = new TiffPredictor(TiffPredictor.FLOATING_POINT, order);
    for (int count : new int[] {3, 20, 7}) { // also shorter rows after a longer one
      byte[] original = randomBytes(2 + count * size);
      byte[] planes = original.clone();
      for (int n = 0; n < count; n++) {
        for (int plane = 0; plane < size; plane++) {
          int place = big ? plane : size - 1 - plane;
          planes[2 + plane * count + n] = original[2 + n * size + place];
        }
      }
      byte[] predicted = planes.clone();
      for (int n = 3; n < planes.length; n++) {
        predicted[n] = (byte) (planes[n] - planes[n - 1]);
      }
      predictor.undo(predicted, 2, count, size, 1);
      assertArrayEquals(original, predicted, "seed=" + SEED);
    }
  }

  @Test
  void withoutAPredictorARowStaysAsItIs() {
    byte[] row = {1, 2, 3};
    new TiffPredictor(TiffPredictor.NONE, ByteOrder.BIG_ENDIAN).undo(row, 0, 3, 1, 1);
    assertArrayEquals(new byte[] {1, 2, 3}, row);
  }

  @Test
  void aDescriptionOfImagejHasItsValues() {
    ImagejDescription found =
        ImagejDescription.of(
            """
            ImageJ=1.54p
            images=12
            channels=2
            slices=3
            frames=2
            unit=micron
            spacing=-2.5
            xorigin=4
            zorigin=x
            cf=0
            c0=-32768.0
            c1=1.0
            no value
            =7
            """);
    assertTrue(found.isImagej());
    assertEquals(12, found.images());
    assertEquals(2, found.channels());
    assertEquals(3, found.slices());
    assertEquals(2, found.frames());
    assertEquals("micron", found.unit());
    assertEquals(1e-3, found.mmPerUnit());
    assertEquals(-2.5, found.spacing());
    assertEquals(4, found.origin(0));
    assertEquals(0, found.origin(1));
    assertEquals(0, found.origin(2));
    assertEquals(new Scaling(1, -32768), found.scaling());
  }

  @Test
  void anotherDescriptionHasNone() {
    ImagejDescription none = ImagejDescription.of("made by hand\nimages=12\nspacing=2\n");
    assertFalse(none.isImagej());
    assertEquals(1, none.images());
    assertEquals(1, none.channels());
    assertEquals(0, none.slices());
    assertEquals(Double.NaN, none.spacing());
    assertEquals(Double.NaN, none.mmPerUnit());
    assertEquals(Scaling.NONE, none.scaling());
    ImagejDescription odd =
        ImagejDescription.of("ImageJ=1\nimages=-3\nchannels=99999\ncf=1\nc0=1\nc1=2\n");
    assertEquals(1, odd.images());
    assertEquals(1 << 15, odd.channels());
    assertEquals(Scaling.NONE, odd.scaling(), "not linear");
    assertEquals(Scaling.NONE, ImagejDescription.of("ImageJ=1\ncf=0\nc0=1\nc1=0\n").scaling());
  }

  private static String ome(String pixels, String inner) {
    return "<?xml version=\"1.0\"?><OME xmlns=\"http://www.openmicroscopy.org\"><Image><Pixels "
        + pixels
        + ">"
        + inner
        + "</Pixels></Image></OME>";
  }

  @ParameterizedTest
  @CsvSource({
    "XYZCT, '0 1 2 6 7 8', '3 4 5 9 10 11'",
    "XYCZT, '0 2 4 6 8 10', '1 3 5 7 9 11'",
    "XYTZC, '0 2 4 1 3 5', '6 8 10 7 9 11'",
    "XYZTC, '0 1 2 3 4 5', '6 7 8 9 10 11'"
  })
  void pagesFollowTheStatedOrder(String order, String first, String second) {
    OmeXml xml =
        OmeXml.of(
                ome(
                    "DimensionOrder=\"" + order + "\" SizeZ=\"3\" SizeC=\"2\" SizeT=\"2\"",
                    "<TiffData/>"))
            .orElseThrow();
    PlaneTable table = xml.planes(12);
    assertEquals(12, table.planes());
    assertEquals(4, table.stacks());
    assertEquals(0, table.missing(12));
    assertEquals(2, table.missing(10));
    assertEquals(first, pages(table, 0) + " " + pages(table, 2), "channel 0 at both times");
    assertEquals(second, pages(table, 1) + " " + pages(table, 3), "channel 1 at both times");
  }

  private static String pages(PlaneTable table, int stack) {
    return table.page(stack, 0) + " " + table.page(stack, 1) + " " + table.page(stack, 2);
  }

  @Test
  void blocksPlaceTheirPages() {
    OmeXml xml =
        OmeXml.of(
                ome(
                    "SizeZ=\"3\" SizeC=\"2\"",
                    "<Channel/><TiffData IFD=\"4\" FirstZ=\"1\" FirstC=\"1\"><UUID"
                        + " FileName=\"b.tif\">u</UUID></TiffData><TiffData IFD=\"0\""
                        + " PlaneCount=\"2\"/>"))
            .orElseThrow();
    PlaneTable table = xml.planes(6);
    assertEquals("0 1 -1", pages(table, 0));
    assertEquals("-1 4 -1", pages(table, 1));
    assertEquals(3, table.missing(6));
    assertEquals(Set.of("b.tif"), xml.fileNames());
    assertEquals("2 channels of 3 slices", table.description());
  }

  @Test
  void spacingsHaveUnitsAndOnlyTheFirstImageCounts() {
    OmeXml xml =
        OmeXml.of(
                ome(
                        "SizeZ=\"3\" PhysicalSizeX=\"0.5\" PhysicalSizeY=\"2\""
                            + " PhysicalSizeYUnit=\"mm\" PhysicalSizeZ=\"-1\"",
                        "")
                    .replace(
                        "</OME>", "<Image><Pixels SizeZ=\"9\" PhysicalSizeX=\"7\"/></Image></OME>"))
            .orElseThrow();
    assertEquals(0.5e-3, xml.spacingMm(0), 1e-15);
    assertEquals(2, xml.spacingMm(1));
    assertEquals(Double.NaN, xml.spacingMm(2));
    assertEquals(2, xml.images());
    assertEquals(3, xml.planes(3).slices());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "no xml",
        "<OME><Image>",
        "<OME></OME>",
        "<OME><Image><Pixels SizeZ=\"0\"/></Image></OME>",
        "<OME><Image><Pixels SizeZ=\"99999\" SizeC=\"99999\"/></Image></OME>",
        "<OME><Image><Pixels DimensionOrder=\"ZYX\"/></Image></OME>"
      })
  void aDescriptionThatIsDamagedIsNoDescription(String text) {
    assertEquals(Optional.empty(), OmeXml.of(text));
  }

  @Test
  void channelsFirstIsTheOrderOfImagej() {
    PlaneTable table = PlaneTable.channelsFirst(3, 2, 2);
    assertEquals("0 2 4", pages(table, 0));
    assertEquals("1 3 5", pages(table, 1));
    assertEquals("6 8 10", pages(table, 2));
    assertEquals(
        "2 times of 3 slices in 2 channels (step = 2 x time + channel)", table.description());
    assertEquals("4 times of 3 slices", new PlaneTable(3, 1, 4).description());
  }
}
