package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.io.dicom.TransferSyntax.Coding;

/** The values of attributes, and how they are written. */
class DicomValuesTest {
  @TempDir private Path folder;

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  @Test
  void paddingIsNoPartOfAText() {
    DicomDataSet set = new DicomDataSet();
    set.put(DicomTag.MODALITY, bytes("  CT \0"));
    assertEquals("CT", set.text(DicomTag.MODALITY));
    set.put(DicomTag.MODALITY, bytes(" \0 "));
    assertEquals("", set.text(DicomTag.MODALITY));
    assertEquals("", set.text(DicomTag.KERNEL));
  }

  @Test
  void decimalsAreDividedByBackslashes() {
    DicomDataSet set = new DicomDataSet();
    set.put(DicomTag.POSITION, bytes("1\\ -2.5 \\3e1"));
    assertArrayEquals(new double[] {1, -2.5, 30}, set.decimals(DicomTag.POSITION));
    assertArrayEquals(new double[] {1, -2.5, 30}, set.decimals(DicomTag.POSITION, 3));
    assertArrayEquals(new double[] {Double.NaN, Double.NaN}, set.decimals(DicomTag.POSITION, 2));
    set.put(DicomTag.POSITION, bytes("1\\\\x"));
    assertArrayEquals(new double[] {1, Double.NaN, Double.NaN}, set.decimals(DicomTag.POSITION));
    assertArrayEquals(new double[0], set.decimals(DicomTag.ORIENTATION));
    assertNull(set.decimals(DicomTag.ORIENTATION, 6));
  }

  @Test
  void numbersHaveAFallbackAndAreCopied() {
    DicomDataSet set = new DicomDataSet();
    assertEquals(7, set.number(DicomTag.ROWS, 7));
    set.put(DicomTag.ROWS);
    assertEquals(7, set.number(DicomTag.ROWS, 7), "an empty value is none");
    int[] values = {3, 4};
    set.put(DicomTag.ROWS, values);
    values[0] = 9;
    assertEquals(3, set.number(DicomTag.ROWS, 7));
    set.numbers(DicomTag.ROWS)[1] = 9;
    assertArrayEquals(new int[] {3, 4}, set.numbers(DicomTag.ROWS));
    assertArrayEquals(new int[0], set.numbers(DicomTag.COLUMNS));
  }

  @Test
  void itemsOfASequenceStayInOrder() {
    DicomDataSet set = new DicomDataSet();
    assertEquals(List.of(), set.items(DicomTag.SEGMENT_SEQUENCE));
    DicomDataSet first = set.addItem(DicomTag.SEGMENT_SEQUENCE);
    DicomDataSet second = set.addItem(DicomTag.SEGMENT_SEQUENCE);
    assertEquals(List.of(first, second), set.items(DicomTag.SEGMENT_SEQUENCE));
  }

  @Test
  void elementsAreWrittenAsTheStandardSays() {
    byte[] written =
        new DicomElements()
            .text(DicomTag.MODALITY, "CS", "SEG")
            .text(DicomTag.SERIES_UID, "UI", "1.2")
            .tag(0x0020_9165, 0x0062_000B)
            .shorts(DicomTag.ROWS, 513)
            .toBytes();
    assertArrayEquals(
        new byte[] {
          8,
          0,
          0x60,
          0,
          'C',
          'S',
          4,
          0,
          'S',
          'E',
          'G',
          ' ',
          0x20,
          0,
          0x0e,
          0,
          'U',
          'I',
          4,
          0,
          '1',
          '.',
          '2',
          0,
          0x20,
          0,
          0x65,
          (byte) 0x91,
          'A',
          'T',
          4,
          0,
          0x62,
          0,
          0x0b,
          0,
          0x28,
          0,
          0x10,
          0,
          'U',
          'S',
          2,
          0,
          1,
          2
        },
        written);
  }

  @Test
  void longValuesAndSequencesHaveWideHeads() {
    byte[] written =
        new DicomElements()
            .sequence(DicomTag.SEGMENT_SEQUENCE, new DicomElements().ints(0x0028_0103, 258))
            .value(DicomTag.PIXELS, "OW", new byte[] {1, 2})
            .toBytes();
    assertArrayEquals(
        new byte[] {
          0x62,
          0,
          2,
          0,
          'S',
          'Q',
          0,
          0,
          20,
          0,
          0,
          0,
          (byte) 0xfe,
          (byte) 0xff,
          0,
          (byte) 0xe0,
          12,
          0,
          0,
          0,
          0x28,
          0,
          3,
          1,
          'U',
          'L',
          4,
          0,
          2,
          1,
          0,
          0,
          (byte) 0xe0,
          0x7f,
          0x10,
          0,
          'O',
          'W',
          0,
          0,
          2,
          0,
          0,
          0,
          1,
          2
        },
        written);
  }

  @ParameterizedTest
  @CsvSource({
    "1.2.840.10008.1.2, PLAIN, Implicit VR Little Endian",
    "1.2.840.10008.1.2.5, RLE, RLE Lossless",
    "1.2.840.10008.1.2.4.50, JPEG, JPEG Baseline",
    "1.2.840.10008.1.2.4.57, JPEG_LOSSLESS, JPEG Lossless",
    "1.2.840.10008.1.2.4.81, JPEG_LS, JPEG-LS Near-Lossless",
    "1.2.840.10008.1.2.4.91, JPEG_2000, JPEG 2000",
    "1.2.840.10008.1.2.4.107, UNREADABLE, HEVC/H.265 Main Profile 5.1",
    "1.2.3, UNREADABLE, transfer syntax 1.2.3",
    "Nobody^Secret, UNREADABLE, transfer syntax without a name"
  })
  void aSyntaxIsKnownByItsNumber(String uid, Coding coding, String name) {
    TransferSyntax syntax = TransferSyntax.of(uid);
    assertEquals(coding, syntax.coding());
    assertEquals(name, syntax.name());
    assertEquals(uid.endsWith(".81"), syntax.isNearLossless());
  }

  @Test
  void bytesAreReadAnywhereInAFile() throws IOException {
    byte[] all = new byte[30_000];
    for (int n = 0; n < all.length; n++) {
      all[n] = (byte) (n * 7 + n / 256);
    }
    Path file = Files.write(folder.resolve("a"), all);
    try (DicomBytes bytes = DicomBytes.open(file)) {
      assertReads(all, bytes);
    }
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    packed.write(new byte[] {9, 9, 9});
    try (OutputStream out =
        new DeflaterOutputStream(packed, new Deflater(Deflater.BEST_SPEED, true))) {
      out.write(all);
    }
    Path deflated = Files.write(folder.resolve("d"), packed.toByteArray());
    try (DicomBytes bytes = DicomBytes.inflated(deflated, 3)) {
      assertReads(all, bytes);
    }
  }

  private static void assertReads(byte[] all, DicomBytes bytes) throws IOException {
    assertEquals(all.length, bytes.length());
    for (int place : new int[] {0, 29_998, 100, 8190, 8192, 20_000, 3}) {
      int expected = ((all[place] & 0xff) << 8) | (all[place + 1] & 0xff);
      assertEquals(
          (short) expected, bytes.at(place, 2, ByteOrder.BIG_ENDIAN).getShort(), "at " + place);
      assertEquals(
          Short.reverseBytes((short) expected),
          bytes.at(place, 2, ByteOrder.LITTLE_ENDIAN).getShort());
    }
    assertEquals(20_000, bytes.at(5000, 20_000, ByteOrder.BIG_ENDIAN).remaining());
    assertEquals(0, bytes.at(30_000, 0, ByteOrder.BIG_ENDIAN).remaining());
    for (long[] beyond : new long[][] {{29_999, 2}, {-1, 1}, {Long.MAX_VALUE, 1}, {0, -1}}) {
      assertEquals(
          "the file ends inside an attribute",
          assertThrows(
                  EOFException.class,
                  () -> bytes.at(beyond[0], (int) beyond[1], ByteOrder.BIG_ENDIAN))
              .getMessage());
    }
  }

  @Test
  void noAttributeThatNamesAPatientIsRead() {
    for (int tag : DicomTag.TEXTS) {
      assertFalse(tag >>> 16 == 0x0010, Integer.toHexString(tag) + " is of the patient");
    }
    assertTrue(DicomTag.TEXTS.contains(DicomTag.POSITION));
  }
}
