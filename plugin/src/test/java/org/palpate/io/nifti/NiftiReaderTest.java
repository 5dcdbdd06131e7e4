package org.palpate.io.nifti;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume;

class NiftiReaderTest {
  private static final long SEED = Seeds.seed();
  private static final double[] IDENTITY = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  @TempDir private Path folder;

  private static VolumeReader open(Path file) throws VolumeFormatException {
    return NiftiReader.open(file, ReadOptions.defaults());
  }

  private Path path() {
    return folder.resolve("v.nii");
  }

  private String refusal(NiftiFile file, int dataBytes) throws IOException {
    Path written = file.write(path(), new byte[dataBytes]);
    VolumeFormatException refusal = assertThrows(VolumeFormatException.class, () -> open(written));
    assertTrue(refusal.getMessage().contains(": " + written + ": "), refusal.getMessage());
    return refusal.getMessage().substring(0, refusal.getMessage().indexOf(": " + written));
  }

  private Vec3 centre(NiftiFile file, double i, double j, double k) throws IOException {
    VolumeHeader header = open(file.write(path(), new byte[60])).header();
    return header.grid().gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
  }

  @ParameterizedTest
  @CsvSource({
    "2, 1, unsigned 8 bit",
    "4, 2, signed 16 bit",
    "8, 4, signed 32 bit",
    "16, 4, 32 bit floating point",
    "64, 8, 64 bit floating point",
    "256, 1, signed 8 bit",
    "512, 2, unsigned 16 bit",
    "768, 4, unsigned 32 bit",
    "1024, 8, signed 64 bit",
    "1280, 8, unsigned 64 bit"
  })
  void everyTypeIsReadInBothVersionsAndByteOrders(int code, int bytes, String description)
      throws IOException {
    for (boolean second : new boolean[] {false, true}) {
      for (ByteOrder order : List.of(ByteOrder.LITTLE_ENDIAN, ByteOrder.BIG_ENDIAN)) {
        NiftiFile file = NiftiFile.of(second, order).dim(3, 3, 2, 1).type(code);
        VolumeReader reader = open(file.write(path(), values(code, bytes, order)));
        assertEquals(second ? "NIfTI-2" : "NIfTI-1", reader.header().format());
        assertEquals(description, reader.header().type().description());
        ScalarVolume volume = GreyVolumes.read(reader);
        for (int n = 0; n < 6; n++) {
          assertEquals(10 * n + 1, volume.value(n % 3, n / 3, 0), order + " " + second);
        }
      }
    }
  }

  private static byte[] values(int code, int bytes, ByteOrder order) {
    ByteBuffer buffer = ByteBuffer.allocate(6 * bytes).order(order);
    for (int n = 0; n < 6; n++) {
      int value = 10 * n + 1;
      switch (bytes) {
        case 1 -> buffer.put((byte) value);
        case 2 -> buffer.putShort((short) value);
        case 4 -> {
          if (code == 16) {
            buffer.putFloat(value);
          } else {
            buffer.putInt(value);
          }
        }
        default -> {
          if (code == 64) {
            buffer.putDouble(value);
          } else {
            buffer.putLong(value);
          }
        }
      }
    }
    return buffer.array();
  }

  @Test
  void theMatrixPlacesVoxels() throws IOException {
    NiftiFile file =
        NiftiFile.first().dim(3, 3, 4, 5).sform(1, 0, -2, 0, 7, 0.5, 0, 0, 8, 0, 0, 3, 9);
    assertEquals("(7.0, 8.0, 9.0)", centre(file, 0, 0, 0).toString());
    assertEquals("(3.0, 8.5, 18.0)", centre(file, 1, 2, 3).toString());
    VolumeHeader header = open(path()).header();
    assertEquals(CoordinateSystem.RAS, header.coordinateSystem());
    assertEquals("(0.5, 2.0, 3.0)", header.grid().spacingMm().toString());
    assertEquals(List.of(), header.notes());
  }

  @ParameterizedTest
  @CsvSource({"1, 1000", "2, 1", "3, 0.001", "0, 1", "10, 1"})
  void lengthsAreConvertedToMillimetres(int unit, double mm) throws IOException {
    NiftiFile file =
        NiftiFile.first().dim(3, 3, 4, 5).unit(unit).sform(1, 2, 0, 0, 1, 0, 2, 0, 1, 0, 0, 2, 1);
    Vec3 at = centre(file, 1, 1, 1);
    assertEquals(3 * mm, at.x, 1e-6 * mm);
    assertEquals(2 * mm, open(path()).header().grid().spacingMm().z, 1e-6 * mm);
  }

  @Test
  void theQuaternionPlacesVoxelsAsARotationDoes() throws IOException {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int round = 0; round < 200; round++) {
      Quaternion q = new Quaternion();
      q.setRotationVector(RandomGeometry.vector(random, 3));
      if (q.w < 0) {
        q.negate(q);
      }
      Vec3 origin = RandomGeometry.vector(random, 100);
      double hand = round % 2 == 0 ? 1 : -1;
      NiftiFile file =
          NiftiFile.second()
              .dim(3, 3, 4, 5)
              .pixdim(hand, 0.5, 1, 2)
              .qform(1, q.x, q.y, q.z, origin.x, origin.y, origin.z);
      Vec3 expected = q.rotate(new Vec3(2 * 0.5, 3, 4 * 2 * hand), new Vec3()).add(origin, origin);
      Vec3 found = centre(file, 2, 3, 4);
      assertEquals(0, expected.sub(found, found).length(), 1e-7, "seed=" + SEED);
    }
  }

  @Test
  void aHandednessOfZeroMeansARightHand() throws IOException {
    NiftiFile file =
        NiftiFile.first().dim(3, 3, 4, 5).pixdim(0, 1, 1, 2).qform(1, 0, 0, 0, 0, 0, 0);
    assertEquals("(1.0, 1.0, 2.0)", centre(file, 1, 1, 1).toString());
  }

  @Test
  void withoutAPositionAxesStayAsTheyAreStored() throws IOException {
    NiftiFile file = NiftiFile.first().dim(3, 3, 4, 5).pixdim(1, 0.5, -1, 2);
    assertEquals("(0.5, 1.0, 2.0)", centre(file, 1, 1, 1).toString());
    VolumeHeader header = open(path()).header();
    assertEquals(CoordinateSystem.UNKNOWN, header.coordinateSystem());
    assertEquals(
        List.of(
            "the spacing along y is stated as -1: its size is used",
            "the orientation in the patient is unknown: axes as stored"),
        header.notes());
  }

  @Test
  void twoPositionsThatDisagreeAreNoted() throws IOException {
    NiftiFile same =
        NiftiFile.first().dim(3, 3, 4, 5).sform(1, IDENTITY).qform(1, 0, 0, 0, 0, 0, 0);
    assertEquals(List.of(), open(same.write(path(), new byte[60])).header().notes());
    NiftiFile moved =
        NiftiFile.first().dim(3, 3, 4, 5).sform(1, IDENTITY).qform(1, 0, 0, 0, 0, 0, 0.25);
    assertEquals(
        List.of(
            "the file states two positions that differ by up to 0.25 mm: its matrix (sform) is"
                + " used, not its quaternion (qform)"),
        open(moved.write(path(), new byte[60])).header().notes());
    NiftiFile stretched =
        NiftiFile.first()
            .dim(3, 3, 4, 5)
            .pixdim(1, 1, 1, 1.5)
            .sform(1, IDENTITY)
            .qform(1, 0, 0, 0, 0, 0, 0);
    assertTrue(
        open(stretched.write(path(), new byte[60])).header().notes().get(0).contains("up to 2 mm"));
    NiftiFile broken =
        NiftiFile.first().dim(3, 3, 4, 5).sform(1, IDENTITY).qform(1, 1, 1, 0, 0, 0, 0);
    assertEquals(
        List.of("the quaternion (qform) is no rotation: the matrix (sform) is used"),
        open(broken.write(path(), new byte[60])).header().notes());
  }

  @Test
  void aQuaternionThatIsNoRotationIsRefused() throws IOException {
    assertEquals(
        "the quaternion (1.0, 1.0, 0.0) is no rotation",
        refusal(NiftiFile.first().dim(3, 3, 4, 5).qform(1, 1, 1, 0, 0, 0, 0), 60));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1|the header has 1 axes, not 2 to 7",
        "8|the header has 8 axes, not 2 to 7",
        "3 0 4 5|the size along x is 0",
        "3 3 -4 5|the size along y is -4",
        "4 3 4 5 -1|the size along axis 4 is -1",
        "3 9999999999 1 1|the size along x is 9999999999",
        "7 1 1 1 70000 70000 70000 1|the header has 343000000000000 time steps"
      })
  void sizesThatCannotBeAreRefused(String dim, String what) throws IOException {
    long[] sizes = java.util.Arrays.stream(dim.split(" ", -1)).mapToLong(Long::parseLong).toArray();
    assertEquals(what, refusal(NiftiFile.second().dim(sizes), 60));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1|the voxels are single bits, not single numbers",
        "32|the voxels are complex numbers, not single numbers",
        "1792|the voxels are complex numbers, not single numbers",
        "1536|the voxels are floating point of 128 bits, not single numbers",
        "77|the voxels are of the unknown type 77, not single numbers"
      })
  void typesThatAreNoNumbersAreRefused(int code, String what) throws IOException {
    assertEquals(what, refusal(NiftiFile.first().type(code), 60));
  }

  @ParameterizedTest
  @CsvSource({"100, 100", "352.5, 352.5", "NaN, NaN", "-1, -1"})
  void dataThatBeginInsideTheHeaderAreRefused(double offset, String text) throws IOException {
    assertEquals(
        "the data begin at byte " + text + ", which is not after the header",
        refusal(NiftiFile.first().offset(offset), 60));
  }

  @Test
  void dataMayBeginLater() throws IOException {
    byte[] data = {0, 0, 0, 0, 42};
    VolumeReader reader = open(NiftiFile.first().offset(356).write(path(), data));
    assertEquals(42, GreyVolumes.read(reader).value(0, 0, 0));
  }

  @Test
  void slopeAndInterceptScaleTheValues() throws IOException {
    VolumeReader reader = open(NiftiFile.first().scaling(2, -5).write(path(), new byte[] {7}));
    assertEquals(9, GreyVolumes.read(reader).value(0, 0, 0));
    assertEquals(-5, reader.header().values().low());
    for (double none : new double[] {0, Double.NaN, Double.POSITIVE_INFINITY}) {
      VolumeReader plain = open(NiftiFile.first().scaling(none, -5).write(path(), new byte[] {7}));
      assertEquals(7, GreyVolumes.read(plain).value(0, 0, 0));
    }
    assertEquals("the intercept is NaN", refusal(NiftiFile.first().scaling(1, Double.NaN), 1));
  }

  @Test
  void aTimeStepIsChosen() throws IOException {
    Path file = NiftiFile.first().dim(4, 2, 1, 1, 3).write(path(), new byte[] {1, 2, 3, 4, 5, 6});
    VolumeFormatException refusal = assertThrows(VolumeFormatException.class, () -> open(file));
    assertTrue(refusal.getMessage().startsWith("the file has 3 time steps or components: "));
    VolumeReader reader = NiftiReader.open(file, ReadOptions.defaults().withTimeStep(1));
    assertEquals(4, GreyVolumes.read(reader).value(1, 0, 0));
    assertEquals(List.of("step 1 of 3, counted from 0"), reader.header().notes().subList(0, 1));
  }

  @Test
  void coloursAreReadAsLuminance() throws IOException {
    byte[] data = {10, 20, 30, (byte) 255, (byte) 255, (byte) 255};
    VolumeReader rgb = open(NiftiFile.first().dim(3, 2, 1, 1).type(128).write(path(), data));
    assertEquals("NIfTI-1, RGB24", rgb.header().format());
    assertEquals(18, GreyVolumes.read(rgb).value(0, 0, 0), "0.299 R + 0.587 G + 0.114 B");
    assertEquals(255, GreyVolumes.read(rgb).value(1, 0, 0));
    byte[] four = {10, 20, 30, 99};
    VolumeReader rgba = open(NiftiFile.second().type(2304).write(path(), four));
    assertEquals("NIfTI-2, RGBA32", rgba.header().format());
    assertEquals(18, GreyVolumes.read(rgba).value(0, 0, 0));
  }

  @Test
  void labelsAreDeclaredByTheIntent() throws IOException {
    assertEquals(
        Optional.of(LabelTable.EMPTY),
        open(NiftiFile.first().intent(1002).write(path(), new byte[1])).header().labels());
    assertEquals(
        Optional.of(LabelTable.EMPTY),
        open(NiftiFile.second().intent(1002).write(path(), new byte[1])).header().labels());
    assertEquals(
        Optional.empty(),
        open(NiftiFile.first().intent(1001).write(path(), new byte[1])).header().labels());
  }

  @Test
  void aGzipFileIsReadThroughout() throws IOException {
    byte[] plain = Files.readAllBytes(NiftiFile.first().write(path(), new byte[] {42}));
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (OutputStream out = new GZIPOutputStream(packed)) {
      out.write(plain);
    }
    Path file = Files.write(folder.resolve("other.bin"), packed.toByteArray());
    assertTrue(NiftiReader.accepts(packed.toByteArray(), file), "known by its contents");
    VolumeReader reader = open(file);
    assertEquals("NIfTI-1, gzip", reader.header().format());
    assertEquals(42, GreyVolumes.read(reader).value(0, 0, 0));
    byte[] damaged = packed.toByteArray();
    Path cut = Files.write(folder.resolve("cut.nii.gz"), java.util.Arrays.copyOf(damaged, 20));
    assertTrue(
        assertThrows(VolumeFormatException.class, () -> open(cut))
            .getMessage()
            .startsWith("the gzip stream is damaged: "));
  }

  @ParameterizedTest
  @ValueSource(strings = {"p.hdr", "p.img"})
  void aPairIsFoundByEitherOfItsFiles(String name) throws IOException {
    NiftiFile.first().magic("ni1\0").offset(0).dim(3, 2, 1, 1).writePair(folder.resolve("p.hdr"));
    Files.write(folder.resolve("p.img"), new byte[] {5, 6});
    VolumeReader reader = open(folder.resolve(name));
    assertEquals(2, reader.files().size());
    assertEquals(6, GreyVolumes.read(reader).value(1, 0, 0));
  }

  @Test
  void aPairNeedsBothFiles() throws IOException {
    Path header = NiftiFile.first().magic("ni1\0").offset(0).writePair(folder.resolve("p.hdr"));
    assertEquals(
        "the second file of the pair, p.img, is missing: "
            + header
            + ": put both files into one folder",
        assertThrows(VolumeFormatException.class, () -> open(header)).getMessage());
  }

  @Test
  void aFileWithoutAHeaderIsRefused() throws IOException {
    Path few = Files.write(path(), new byte[100]);
    assertEquals(
        "the file ends inside its header: " + few + ": copy or export the file again",
        assertThrows(VolumeFormatException.class, () -> open(few)).getMessage());
    Path zeros = Files.write(path(), new byte[600]);
    assertTrue(
        assertThrows(VolumeFormatException.class, () -> open(zeros))
            .getMessage()
            .startsWith("the file has no header of NIfTI or Analyze 7.5: "));
    assertEquals(
        "the header promises 60 bytes of data but the file has 59",
        refusal(NiftiFile.first().dim(3, 3, 4, 5), 59));
  }

  @Test
  void aSingleSliceHasADepth() throws IOException {
    VolumeHeader header =
        open(NiftiFile.first().dim(2, 3, 4).pixdim(1, 0.5, 0.25, 0).write(path(), new byte[12]))
            .header();
    assertEquals(1, header.grid().sizeZ());
    assertEquals("(0.5, 0.25, 1.0)", header.grid().spacingMm().toString());
  }
}
