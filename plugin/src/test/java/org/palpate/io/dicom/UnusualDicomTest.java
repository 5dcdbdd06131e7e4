package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Reads and refuses DICOM images made here: each is a kind that a scanner or a tool writes. */
class UnusualDicomTest {
  private static final ReadOptions ANY = ReadOptions.defaults();
  private static final double TOLERANCE = 1e-9;
  private static final String JPEG_BASELINE = "1.2.840.10008.1.2.4.50";

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({
    "1.2.840.10008.1.2.4.51, JPEG Extended",
    "1.2.840.10008.1.2.4.100, MPEG-2 Main Profile",
    "1.2.840.10008.1.2.4.102, MPEG-4 AVC/H.264 High Profile 4.1",
    "1.2.840.10008.1.2.4.107, HEVC/H.265 Main Profile 5.1",
    "1.2.840.10008.1.2.4.110, JPEG XL Lossless",
    "1.2.840.10008.1.2.4.201, High-Throughput JPEG 2000",
    "1.2.3.4, transfer syntax 1.2.3.4",
  })
  void otherTransferSyntaxesAreRefusedByName(String uid, String name) throws Exception {
    requireRefusal(image().compressed(uid, new byte[64]), name);
  }

  @Test
  void aSiemensMosaicIsRefusedByName() throws Exception {
    requireRefusal(
        image().text(DicomTag.IMAGE_TYPE, "CS", "ORIGINAL\\PRIMARY\\M\\ND\\MOSAIC"),
        "Siemens mosaic");
  }

  @Test
  void aWholeSlideImageIsRefusedByName() throws Exception {
    requireRefusal(
        image().text(DicomTag.SOP_CLASS, "UI", "1.2.840.10008.5.1.4.1.1.77.1.6"), "whole-slide");
  }

  @Test
  void aPaletteIsRefusedByName() throws Exception {
    requireRefusal(image().text(DicomTag.PHOTOMETRIC, "CS", "PALETTE COLOR"), "palette");
  }

  @Test
  void aTableOfValuesIsRefusedByName() throws Exception {
    requireRefusal(
        image().sequence(DicomTag.MODALITY_TABLE_SEQUENCE, new DicomElements()),
        "Modality LUT Sequence");
  }

  @Test
  void aFilmIsNotTakenForAVolume() throws Exception {
    requireRefusal(
        image().without(DicomTag.POSITION).text(DicomTag.FRAMES, "IS", "3").bytes(new byte[36]),
        "3 frames have neither positions nor SpacingBetweenSlices");
  }

  @ParameterizedTest
  @CsvSource({"RTSTRUCT, contours", "SR, a report", "PR, how to show"})
  void aFileWithoutImageIsRefusedByWhatItHolds(String modality, String says) throws Exception {
    requireRefusal(image().without(DicomTag.PIXELS).text(DicomTag.MODALITY, "CS", modality), says);
  }

  @Test
  void coloursAreReadAsLuminanceInBothOrders() throws Exception {
    byte[] pixels = new byte[3 * 12];
    byte[] planes = new byte[3 * 12];
    for (int n = 0; n < 12; n++) {
      byte[] rgb = {(byte) (20 * n), (byte) (255 - n), (byte) (7 * n)};
      for (int part = 0; part < 3; part++) {
        pixels[3 * n + part] = rgb[part];
        planes[12 * part + n] = rgb[part];
      }
    }
    VolumeReader reader = read(colour().bytes(pixels));
    assertEquals(luminance(11), values(reader).get(11), TOLERANCE);
    assertEquals(values(reader), values(read(colour().number(DicomTag.PLANAR, 1).bytes(planes))));
    assertTrue(reader.header().notes().toString().contains("luminance"));
    // of YBR_FULL the first part is the luminance
    List<Double> first =
        values(read(colour().text(DicomTag.PHOTOMETRIC, "CS", "YBR_FULL").bytes(pixels)));
    assertEquals(220, first.get(11), TOLERANCE);
  }

  private static double luminance(int n) {
    return Math.rint(0.299 * 20 * n + 0.587 * (255 - n) + 0.114 * 7 * n);
  }

  private static DicomTestFile colour() {
    return image().number(DicomTag.SAMPLES, 3).text(DicomTag.PHOTOMETRIC, "CS", "RGB");
  }

  @Test
  void coloursOfAnotherKindAreRefused() throws Exception {
    requireRefusal(
        colour().text(DicomTag.PHOTOMETRIC, "CS", "YBR_FULL_422").bytes(new byte[36]),
        "colours (3 numbers each, YBR_FULL_422");
  }

  @Test
  void greyJpegIsReadWithANoteOfItsLoss() throws Exception {
    BufferedImage image = new BufferedImage(4, 3, BufferedImage.TYPE_BYTE_GRAY);
    image.getRaster().setSamples(0, 0, 4, 3, 0, filled(130));
    VolumeReader reader = read(image().bytes(new byte[12]).compressed(JPEG_BASELINE, jpeg(image)));
    for (double value : values(reader)) {
      assertEquals(130, value, 1);
    }
    assertTrue(reader.header().notes().toString().contains("loss"));
  }

  /** The example of ITU-T T.87, H.3, is lossless, which the near-lossless syntax allows. */
  @Test
  void nearLosslessJpegLsIsReadWithANote() throws Exception {
    byte[] stream =
        HexFormat.of()
            .parseHex(
                "ffd8fff7000b080004000401011100ffda0008010100000000c000006c80208e01c00000574000"
                    + "006ee6000001bc18000005d800009160ffd9");
    VolumeReader reader =
        read(
            image()
                .bytes(new byte[16])
                .number(DicomTag.ROWS, 4)
                .compressed("1.2.840.10008.1.2.4.81", stream));
    assertEquals(List.of(0.0, 0.0, 90.0, 74.0), values(reader).subList(0, 4));
    assertTrue(reader.header().notes().toString().contains("may have been compressed with loss"));
  }

  @Test
  void colourJpegIsReadAsLuminance() throws Exception {
    BufferedImage image = new BufferedImage(4, 3, BufferedImage.TYPE_INT_RGB);
    image.getRaster().setSamples(0, 0, 4, 3, 0, filled(200));
    image.getRaster().setSamples(0, 0, 4, 3, 1, filled(100));
    DicomTestFile file =
        colour().text(DicomTag.PHOTOMETRIC, "CS", "YBR_FULL_422").bytes(new byte[36]);
    for (double value : values(read(file.compressed(JPEG_BASELINE, jpeg(image))))) {
      assertEquals(0.299 * 200 + 0.587 * 100, value, 2);
    }
  }

  private static int[] filled(int value) {
    int[] all = new int[12];
    Arrays.fill(all, value);
    return all;
  }

  private static byte[] jpeg(BufferedImage image) throws Exception {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ImageIO.write(image, "jpeg", out);
    return out.toByteArray();
  }

  @Test
  void echoesAndTimesTogetherAreSteps() throws Exception {
    for (int n = 0; n < 12; n++) {
      new DicomTestFile(n % 2, 100 * n)
          .text(DicomTag.ECHO_TIME, "DS", n / 2 % 2 == 0 ? "4.5" : "12")
          .text(DicomTag.TRIGGER_TIME, "DS", Integer.toString(90 * (n / 4)))
          .write(folder.resolve("image" + n));
    }
    assertTrue(
        refusal().contains("3 times (0, 90, 180 ms) x 2 echoes (4.5, 12 ms), each of 2 slices"),
        refusal());
    assertEquals(List.of(600.0, 700.0), firsts(VolumeFiles.open(folder, ANY.withTimeStep(3))));
  }

  @Test
  void anIncompleteTimeIsRefusedWhenChosen() throws Exception {
    for (int n = 0; n < 5; n++) {
      new DicomTestFile(n % 3, 100 * n)
          .text(DicomTag.TEMPORAL_POSITION, "IS", Integer.toString(1 + n / 3))
          .write(folder.resolve("image" + n));
    }
    assertEquals(List.of(0.0, 100.0, 200.0), firsts(VolumeFiles.open(folder, ANY.withTimeStep(0))));
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class, () -> VolumeFiles.open(folder, ANY.withTimeStep(1)));
    assertTrue(refused.getMessage().contains("step 1 has 2 of 3 slices"), refused.getMessage());
  }

  @Test
  void imagesToldApartByTheirNumbersAloneAreSteps() throws Exception {
    for (int n = 0; n < 4; n++) {
      int slice = n / 2;
      new DicomTestFile(slice, 100 * n)
          .text(DicomTag.INSTANCE_NUMBER, "IS", Integer.toString(10 - n))
          .write(folder.resolve("image" + n));
    }
    assertTrue(refusal().contains("2 images at each position"), refusal());
    assertEquals(List.of(100.0, 300.0), firsts(VolumeFiles.open(folder, ANY.withTimeStep(0))));
  }

  @Test
  void stacksOfOneFileAreSteps() throws Exception {
    DicomElements[] frames = new DicomElements[4];
    for (int n = 0; n < 4; n++) {
      String axes = n < 2 ? "1\\0\\0\\0\\1\\0" : "0\\1\\0\\0\\0\\-1";
      String at = n < 2 ? "0\\0\\" + 3 * n : 5 * n + "\\0\\0";
      frames[n] =
          new DicomElements()
              .sequence(
                  DicomTag.FRAME_CONTENT_SEQUENCE,
                  new DicomElements().text(DicomTag.STACK_ID, "SH", Integer.toString(n / 2)))
              .sequence(
                  DicomTag.PLANE_POSITION_SEQUENCE,
                  new DicomElements().text(DicomTag.POSITION, "DS", at))
              .sequence(
                  DicomTag.PLANE_ORIENTATION_SEQUENCE,
                  new DicomElements().text(DicomTag.ORIENTATION, "DS", axes));
    }
    image()
        .without(DicomTag.POSITION)
        .text(DicomTag.FRAMES, "IS", "4")
        .sequence(DicomTag.FRAME_GROUPS, frames)
        .bytes(new byte[48])
        .write(folder.resolve("stacks.dcm"));
    assertTrue(refusal().contains("2 stacks: 2 slices; 2 slices"), refusal());
    VolumeReader second = VolumeFiles.open(folder, ANY.withTimeStep(1));
    assertEquals(5, second.header().grid().spacingMm().z, TOLERANCE);
  }

  @Test
  void aCopyInAnotherEncodingIsDroppedIfItsInstanceIsTheSame() throws Exception {
    new DicomTestFile(0, 5).text(DicomTag.SOP_INSTANCE, "UI", "1.7").write(folder.resolve("a"));
    new DicomTestFile(1, 6).text(DicomTag.SOP_INSTANCE, "UI", "1.8").write(folder.resolve("b"));
    new DicomTestFile(0, 5)
        .text(DicomTag.SOP_INSTANCE, "UI", "1.7")
        .text(DicomTag.IMAGE_TYPE, "CS", "DERIVED")
        .write(folder.resolve("a again"));
    VolumeReader reader = VolumeFiles.open(folder, ANY);
    assertEquals(List.of(5.0, 6.0), firsts(reader));
    assertTrue(reader.header().notes().toString().contains("a again"));
  }

  @Test
  void possibleCopiesThatAreLargerThanAnyMemoryAreRefused() throws Exception {
    for (String kind : List.of("ORIGINAL", "DERIVED")) {
      image()
          .text(DicomTag.SOP_INSTANCE, "UI", "1.7")
          .text(DicomTag.IMAGE_TYPE, "CS", kind)
          .number(DicomTag.ROWS, 65535)
          .number(DicomTag.COLUMNS, 65535)
          .compressed("1.2.840.10008.1.2.4.80", new byte[70_000])
          .write(folder.resolve(kind));
    }
    assertTrue(refusal().startsWith("comparing two frames needs 69 GB of memory"), refusal());
  }

  @ParameterizedTest
  @CsvSource({"0\\\\4\\\\8, 8", "2\\\\6\\\\10, 10", "0\\\\-4\\\\-8, 2"})
  void doseOffsetsAreRelativeOrAbsolute(String offsets, double lastZ) throws Exception {
    VolumeReader reader =
        read(
            new DicomTestFile(2, 0)
                .text(DicomTag.MODALITY, "CS", "RTDOSE")
                .text(DicomTag.FRAMES, "IS", "3")
                .text(DicomTag.FRAME_OFFSETS, "DS", offsets.replace("\\\\", "\\"))
                .text(DicomTag.DOSE_SCALING, "DS", "0.5")
                .text(DicomTag.DOSE_UNITS, "CS", "RELATIVE")
                .bytes(new byte[36]));
    Vec3 last = reader.header().grid().gridToWorld(new Vec3(0.5, 0.5, 2.5), new Vec3());
    assertEquals(offsets.startsWith("0") && lastZ == 8 ? 10 : lastZ, last.z, TOLERANCE);
    assertTrue(reader.header().notes().toString().contains("relative"));
  }

  @Test
  void noNoteAndNoRefusalNamesThePatient() throws Exception {
    image().write(folder.resolve("a.dcm"));
    image().text(DicomTag.STACK_ID, "SH", "Secret").write(folder.resolve("b.dcm"));
    assertFalse(refusal().contains("Secret"), refusal());
  }

  /**
   * Bytes of 8-bit pixels stand in words, so the byte order swaps them; 5x3 pixels have odd frames.
   */
  @Test
  void bytesInBigEndianWordsAreSwapped() throws Exception {
    ByteBuffer file = ByteBuffer.allocate(1000); // big-endian
    file.put(new byte[128]).put("DICM".getBytes(StandardCharsets.ISO_8859_1));
    byte[] meta =
        new DicomElements()
            .text(DicomTag.TRANSFER_SYNTAX, "UI", TransferSyntax.BIG_ENDIAN)
            .toBytes();
    file.put(meta); // without the length of group 2, as some tools write it
    bigEndian(file, DicomTag.SLICE_SPACING, "DS", "1 ".getBytes(StandardCharsets.US_ASCII));
    bigEndian(file, DicomTag.SAMPLES, "US", new byte[] {0, 1});
    bigEndian(file, DicomTag.FRAMES, "IS", "2 ".getBytes(StandardCharsets.US_ASCII));
    bigEndian(file, DicomTag.ROWS, "US", new byte[] {0, 3});
    bigEndian(file, DicomTag.COLUMNS, "US", new byte[] {0, 5});
    bigEndian(file, DicomTag.BITS_ALLOCATED, "US", new byte[] {0, 8});
    byte[] pixels = new byte[30];
    for (int n = 0; n < 30; n++) {
      pixels[n ^ 1] = (byte) n;
    }
    file.putShort((short) 0x7FE0)
        .putShort((short) 0x0010)
        .put("OW".getBytes(StandardCharsets.US_ASCII));
    file.putShort((short) 0).putInt(pixels.length).put(pixels);
    Path path = Files.write(folder.resolve("b.dcm"), Arrays.copyOf(file.array(), file.position()));
    List<Double> values = values(VolumeFiles.open(path, ANY));
    for (int n = 0; n < 30; n++) {
      assertEquals(n, values.get(n), TOLERANCE);
    }
  }

  private static void bigEndian(ByteBuffer file, int tag, String vr, byte[] value) {
    file.putShort((short) (tag >>> 16)).putShort((short) tag);
    file.put(vr.getBytes(StandardCharsets.US_ASCII)).putShort((short) value.length).put(value);
  }

  @Test
  void aBareDataSetIsReadAlone() throws Exception {
    Path file = Files.write(folder.resolve("bare"), image().dataSet());
    assertEquals(11, values(VolumeFiles.open(file, ANY)).get(11), TOLERANCE);
  }

  private static DicomTestFile image() {
    return new DicomTestFile(0, 0);
  }

  private VolumeReader read(DicomTestFile file) throws Exception {
    return VolumeFiles.open(file.write(folder.resolve("a.dcm")), ANY);
  }

  private void requireRefusal(DicomTestFile file, String says) throws Exception {
    Path path = file.write(folder.resolve("a.dcm"));
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> VolumeFiles.open(path, ANY));
    assertTrue(refused.getMessage().contains(says), refused.getMessage());
    assertEquals(1, refused.getMessage().lines().count());
  }

  private String refusal() {
    return assertThrows(VolumeFormatException.class, () -> VolumeFiles.open(folder, ANY))
        .getMessage();
  }

  private static List<Double> values(VolumeReader reader) throws VolumeFormatException {
    List<Double> values = new ArrayList<>();
    reader.read(
        (k, slice) -> {
          for (int n = 0; n < slice.count(); n++) {
            values.add(slice.value(n));
          }
        });
    return values;
  }

  /** Returns the first value of each slice. */
  private static List<Double> firsts(VolumeReader reader) throws VolumeFormatException {
    List<Double> values = new ArrayList<>();
    reader.read((k, slice) -> values.add(slice.value(0)));
    return values;
  }
}
