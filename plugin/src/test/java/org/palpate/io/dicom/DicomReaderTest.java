package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.testing.Scans;

/**
 * Values agree with pydicom 3.0.2 (pixel_array times slope plus intercept, slices by the third
 * number of the position); checksums as {@link VoxelCrc} defines them.
 */
class DicomReaderTest {
  private static final double WORLD_TOLERANCE_MM = 1e-9;

  @ParameterizedTest
  @CsvSource({
    "CT_small.dcm, dffa7304",
    "MR_small.dcm, f891ef3b",
    "MR_small_RLE.dcm, f891ef3b",
    "MR_small_bigendian.dcm, f891ef3b",
    "MR_small_implicit.dcm, f891ef3b",
    "MR_small_jp2klossless.dcm, f891ef3b",
    "emri_small.dcm, c781bf1f",
    "image_dfl.dcm, b3163987",
    "MR_small_jpeg_ls_lossless.dcm, f891ef3b",
  })
  void singleFilesAgreeWithPydicom(String name, String crc) throws Exception {
    assertEquals(crc, VoxelCrc.of(open("formats/dicom/" + name)));
  }

  @Test
  void aFolderIsSortedByPositionNotByName() throws Exception {
    VolumeReader reader = open("LIDC/dicom_10slices");
    assertEquals("c36c6513", VoxelCrc.of(reader));
    requireWorld(reader, 0, -201, -59, -539.800049);
    requireWorld(reader, 9, -201, -59, -530.800049);
    assertEquals(10, reader.header().grid().sizeZ());
    assertEquals(
        81_199,
        SegmentBuilder.read(reader, List.of(SegmentSpec.atLeast("bone", 200)))
            .segments()
            .get(0)
            .bits()
            .solidCount());
  }

  @Test
  void takesSpacingFromPositionsNotFromThickness() throws Exception {
    // data/README.md: thickness 3, positions 2, empty series UID, JPEG 2000
    VolumeReader reader = open("totalseg/dicom_j2k");
    assertEquals("28052498", VoxelCrc.of(reader));
    assertEquals(2, reader.header().grid().spacingMm().z, WORLD_TOLERANCE_MM);
    requireWorld(reader, 0, -249.51171875, -437.51171875, -804.5);
    requireWorld(reader, 19, -249.51171875, -437.51171875, -766.5);
  }

  @ParameterizedTest
  @CsvSource({
    "formats/malformed/MR_truncated.dcm, damaged",
    "formats/malformed/badVR.dcm, frames is no",
    "formats/malformed/meta_missing_tsyntax.dcm, no transfer syntax",
    "formats/malformed/no_meta.dcm, DICM",
    "formats/malformed/rtplan_truncated.dcm, a",
  })
  void refusesUnreadableFilesInOneLineWithARemedy(String name, String says) {
    Path file = Scans.file(name);
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class, () -> VolumeFiles.open(file, ReadOptions.defaults()));
    assertTrue(refused.getMessage().contains(says), refused.getMessage());
    assertEquals(1, refused.getMessage().lines().count());
    assertTrue(refused.getMessage().split(": ", -1).length >= 3, refused.getMessage());
  }

  @Test
  void aFolderOfSeveralSeriesIsListedAndOneChosen() throws Exception {
    Path folder = Scans.file("formats/dicom");
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class, () -> VolumeFiles.open(folder, ReadOptions.defaults()));
    assertTrue(refused.getMessage().contains("--series 1 to --series"), refused.getMessage());
  }

  /** JJ2000 would take two bytes of 0xFF in a packet header for an endless run of ones. */
  @Test
  void refusesDamageThatWouldHangTheJpeg2000Library(@TempDir Path folder) throws Exception {
    byte[] whole = Files.readAllBytes(Scans.file("formats/dicom/MR_small_jp2klossless.dcm"));
    int from = offset(whole, 0xFF93) + 2; // start of data
    int to = offset(whole, 0xFFD9) - 2; // end of the picture
    for (int at = from; at < to; at++) {
      byte[] spoiled = whole.clone();
      spoiled[at] = -1;
      spoiled[at + 1] = -1;
      VolumeReader reader =
          VolumeFiles.open(
              Files.write(folder.resolve("spoiled.dcm"), spoiled), ReadOptions.defaults());
      VolumeFormatException refused =
          assertThrows(VolumeFormatException.class, () -> reader.read((k, slice) -> {}));
      assertTrue(refused.getMessage().contains("pixels are damaged"), refused.getMessage());
    }
  }

  private static int offset(byte[] bytes, int marker) {
    int at = 0;
    while (bytes[at] != (byte) (marker >> 8) || bytes[at + 1] != (byte) marker) {
      at++;
    }
    return at;
  }

  @Test
  void anOptionWithoutAChoiceIsRefused() {
    Path file = Scans.file("formats/dicom/CT_small.dcm");
    ReadOptions any = ReadOptions.defaults();
    for (ReadOptions options : List.of(any.withTimeStep(3), any.withSeries("2"))) {
      VolumeFormatException refused =
          assertThrows(VolumeFormatException.class, () -> VolumeFiles.open(file, options));
      assertTrue(refused.getMessage().contains("leave --"), refused.getMessage());
    }
  }

  private static void requireWorld(VolumeReader reader, int k, double x, double y, double z) {
    Vec3 world = reader.header().grid().gridToWorld(new Vec3(0.5, 0.5, k + 0.5), new Vec3());
    assertEquals(x, world.x, WORLD_TOLERANCE_MM);
    assertEquals(y, world.y, WORLD_TOLERANCE_MM);
    assertEquals(z, world.z, WORLD_TOLERANCE_MM);
  }

  private static VolumeReader open(String name) throws VolumeFormatException {
    return VolumeFiles.open(Scans.file(name), ReadOptions.defaults());
  }
}
