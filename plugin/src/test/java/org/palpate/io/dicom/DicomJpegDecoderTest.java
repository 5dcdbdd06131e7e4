package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;

class DicomJpegDecoderTest {
  private static final int IMAGES = 2000;
  private static final int MAX_EDGE = 12;
  private static final String JPEG_LOSSLESS_FIRST_ORDER = "1.2.840.10008.1.2.4.70";

  @Test
  void decodesEveryPixelWhereverTheCodedDataEnd() throws IOException {
    long seed = Long.getLong("palpate.seed", System.nanoTime());
    Random random = new Random(seed);
    for (int image = 0; image < IMAGES; image++) {
      int columns = 1 + random.nextInt(MAX_EDGE);
      int rows = 1 + random.nextInt(MAX_EDGE);
      int bits = 1 + random.nextInt(16);
      int[] pixels = random.ints((long) columns * rows, 0, 1 << bits).toArray();
      byte[] jpeg = LosslessJpegEncoder.encode(pixels, columns, rows);
      byte[] fragment = Arrays.copyOf(jpeg, jpeg.length + jpeg.length % 2);
      int[] decoded = new int[pixels.length];
      DicomJpegDecoder.decode(dicom(columns, rows), fragment, decoded, pixels.length);
      assertArrayEquals(pixels, decoded, "image " + image + " with seed " + seed);
    }
  }

  private static DicomFile dicom(int columns, int rows) {
    DicomDataSet attributes = new DicomDataSet();
    attributes.put(DicomTag.COLUMNS, columns);
    attributes.put(DicomTag.ROWS, rows);
    return new DicomFile(
        Path.of("test.dcm"),
        attributes,
        TransferSyntax.of(JPEG_LOSSLESS_FIRST_ORDER),
        -1,
        ByteOrder.LITTLE_ENDIAN,
        List.of(),
        true,
        false);
  }
}
