package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.testing.Scans;

/**
 * Values and positions agree with the formats' own readers: nibabel 5.4.2, pynrrd 1.1.3 and
 * SimpleITK 2.5.7, over numpy 2.4.6. Checksums as {@link VoxelCrc} defines them.
 */
class ReferenceReadersTest {
  private static final double WORLD_TOLERANCE_MM = 1e-9;

  // pynrrd: nrrd.read(file)
  @ParameterizedTest
  @CsvSource({
    "BallBinary30x30x30.nhdr, 6477ce93",
    "BallBinary30x30x30.nrrd, 6477ce93",
    "BallBinary30x30x30_byteskip_minus_one.nhdr, 6477ce93",
    "BallBinary30x30x30_byteskip_minus_one_nifti.nhdr, 6477ce93",
    "BallBinary30x30x30_bz2.nrrd, 6477ce93",
    "BallBinary30x30x30_gz.nrrd, 6477ce93",
    "BallBinary30x30x30_gz_byteskip_minus_one.nrrd, 6477ce93",
    "BallBinary30x30x30_gz_lineskip.nrrd, 6477ce93",
    "test2d_ascii.nrrd, 777b8d44",
    "test_simple4d_raw.nrrd, 59351477",
  })
  void nrrdAgreesWithPynrrd(String name, String crc) throws Exception {
    assertEquals(crc, VoxelCrc.of(open("formats/nrrd/" + name, OptionalInt.empty())));
  }

  @ParameterizedTest
  @CsvSource({"HN-Atlas-labels.nrrd, e0e2aa8d", "Skull.nrrd, 17876177"})
  void labelFilesAgreeWithPynrrd(String name, String crc) throws Exception {
    assertEquals(crc, VoxelCrc.of(open("labels/" + name, OptionalInt.empty())));
  }

  @ParameterizedTest
  @CsvSource({"test1d_ascii.nrrd", "test_customFields.nrrd"})
  void aNrrdOfOneAxisIsRefused(String name) {
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class, () -> open("formats/nrrd/" + name, OptionalInt.empty()));
    assertTrue(refused.getMessage().contains("spatial axes"), refused.getMessage());
  }

  // SimpleITK: sitk.GetArrayFromImage(sitk.ReadImage(file)).transpose(2, 1, 0)
  @ParameterizedTest
  @CsvSource({
    "blob0.mha, 6f74dc67",
    "blob4.mha, bce1755f",
    "fuel.mha, e07affaf",
    "hydrogenAtom.mha, 4ccb0498",
    "marschnerlobb.mha, cdc7d9cb",
    "nucleon.mha, a2f76185",
  })
  void metaImageAgreesWithSimpleItk(String name, String crc) throws Exception {
    VolumeReader reader = open("formats/mha/" + name, OptionalInt.empty());
    assertEquals(crc, VoxelCrc.of(reader));
    requireWorld(reader, 3, 2, 1, 3, 2, 1);
  }

  // tifffile 2026.3.3: tifffile.imread(file).transpose(2, 1, 0)
  @ParameterizedTest
  @CsvSource({
    "u16_bigtiff, 61789cdd",
    "u16_deflate, 61789cdd",
    "u16_imagej, 61789cdd",
    "u16_lzw_pred, 61789cdd",
    "u16_tiled64, 61789cdd",
    "u16be_none, 61789cdd",
    "u16le_none, 61789cdd",
    "u8_packbits, 7cfb6bfd",
  })
  void tiffAgreesWithTifffile(String name, String crc) throws Exception {
    VolumeReader reader = open("formats/tiff/CThead_z41-56_" + name + ".tif", OptionalInt.empty());
    assertEquals(crc, VoxelCrc.of(reader));
    double spacingZ = name.equals("u16_imagej") ? 2 : 1;
    requireWorld(reader, 3, 2, 1, 3, 2, spacingZ);
  }

  // nibabel: numpy.asanyarray(image.dataobj), and image.affine applied to voxels 0,0,0 and 3,2,1
  @ParameterizedTest
  @CsvSource({
    "formats/nifti/anatomical.nii, -1, 14c653ac, 32, -40, -16, 26, -36, -14",
    "formats/nifti/big.nii.gz, -1, 20d86d8d, 0, 0, 0, -12, 8, 6",
    "formats/nifti/little.nii.gz, -1, 20d86d8d, 0, 0, 0, -12, 8, 6",
    "formats/nifti/example4d.nii.gz, 0, ceb3c2f0, 117.8551025390625, -35.72294235229492,"
        + " -7.248798370361328, 111.8551025390625, -32.1310476064682, -4.4313013553619385",
    "formats/nifti/example4d.nii.gz, 1, 8cd6e1df, 117.8551025390625, -35.72294235229492,"
        + " -7.248798370361328, 111.8551025390625, -32.1310476064682, -4.4313013553619385",
    "formats/nifti/example_nifti2.nii.gz, 1, a83f1430, 117.8551025390625, -35.72294235229492,"
        + " -7.248798370361328, 111.8551025390625, -32.1310476064682, -4.4313013553619385",
    "formats/nifti/functional.nii, 1, 64e5f73a, 32, -40, 0, 20, -32, 8",
    "formats/nifti/reoriented_anat_moved.nii, -1, 15da40b3, -35.29789733886719,"
        + " -47.97758483886719, -27.599409103393555, -23.297897338867188, -39.97758483886719,"
        + " -23.599409103393555",
    "formats/nifti/standard.nii.gz, -1, 0ebcc865, 0, 0, 0, 3, 6, 2",
    "formats/nrrd/BallBinary30x30x30.nii.gz, -1, 6477ce93, 0, 0, 0, -3, -2, 1",
    "totalseg/example_ct.nii.gz, -1, 6a5bef67, -177.95632934570312, 11.319000244140625,"
        + " 94.3017578125, -168.95632934570312, 17.319000244140625, 97.3017578125",
    "totalseg/example_seg_dicom.nii.gz, -1, 757f0cd7, 249.51171875, -61.51171875, -804.5,"
        + " 246.58203125, -59.55859375, -802.5",
    "totalseg/example_seg_fast_force_split.nii.gz, -1, e07a933e, -177.95632934570312,"
        + " 11.319000244140625, 94.3017578125, -168.95632934570312, 17.319000244140625,"
        + " 97.3017578125",
  })
  void niftiAgreesWithNibabel(
      String name, int time, String crc, double x0, double y0, double z0, double x, double y)
      throws Exception {
    VolumeReader reader = open(name, time < 0 ? OptionalInt.empty() : OptionalInt.of(time));
    assertEquals(crc, VoxelCrc.of(reader));
    requireWorld(reader, 0, 0, 0, x0, y0, z0);
    Vec3 far = reader.header().grid().gridToWorld(new Vec3(3.5, 2.5, 1.5), new Vec3());
    assertEquals(x, far.x, WORLD_TOLERANCE_MM);
    assertEquals(y, far.y, WORLD_TOLERANCE_MM);
  }

  @Test
  void aVolumeOverTimeAsksForAStep() {
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class,
            () -> open("formats/nifti/functional.nii", OptionalInt.empty()));
    assertTrue(refused.getMessage().contains("--time 0 to --time 19"), refused.getMessage());
    assertThrows(
        VolumeFormatException.class,
        () -> open("formats/nifti/functional.nii", OptionalInt.of(20)));
  }

  private static void requireWorld(
      VolumeReader reader, int i, int j, int k, double x, double y, double z) {
    Vec3 world =
        reader.header().grid().gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
    assertEquals(x, world.x, WORLD_TOLERANCE_MM);
    assertEquals(y, world.y, WORLD_TOLERANCE_MM);
    assertEquals(z, world.z, WORLD_TOLERANCE_MM);
  }

  private static VolumeReader open(String name, OptionalInt time) throws VolumeFormatException {
    ReadOptions options = ReadOptions.defaults();
    return VolumeFiles.open(
        Scans.file(name), time.isPresent() ? options.withTimeStep(time.getAsInt()) : options);
  }
}
