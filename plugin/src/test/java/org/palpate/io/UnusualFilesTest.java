package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

/**
 * Reads the unusual files of {@code cases} as its README says: a volume of 7x6x5 voxels with value
 * x + 10 y + 100 z unless stated otherwise.
 */
class UnusualFilesTest {
  private static final int SIZE_X = 7;
  private static final int SIZE_Y = 6;
  private static final int SIZE_Z = 5;
  private static final String BOX = "x 0-6, y 0-5, z 2-4";

  /** The value of a voxel by its indices. */
  private interface Values {
    double of(int x, int y, int z);
  }

  private static final Values PLAIN = (x, y, z) -> x + 10 * y + 100 * z;

  @ParameterizedTest
  @CsvSource({
    "nrrd/detached/vol.nhdr, 0.5, 0.75, 2",
    "mha/intensity_slope.mha, 0.5, 0.75, 2",
    "nifti/qform_vs_sform.nii.gz, 3, 2.875, 2.875",
    "nifti/analyze75.hdr, 0.5, 0.75, 2",
    "tiff/ij_stack_pixel.tif, 0.5, 0.75, 2",
    "tiff/ome_zspacing.ome.tif, 0.0005, 0.00075, 0.002",
    "tiff/folder, 1, 1, 1",
  })
  void theVolumeIsReadToTheVoxelWithItsSpacing(String name, double x, double y, double z)
      throws Exception {
    VolumeReader reader = open(name);
    requireValues(reader, PLAIN);
    Vec3 spacing = reader.header().grid().spacingMm();
    assertEquals(x, spacing.x, 1e-4 * x);
    assertEquals(y, spacing.y, 1e-4 * y);
    assertEquals(z, spacing.z, 1e-4 * z);
    Segment bone = segment(reader, SegmentSpec.atLeast("bone", 223));
    assertEquals(109, bone.bits().solidCount());
    assertEquals(BOX, bone.bits().bounds().toString());
  }

  @ParameterizedTest
  @CsvSource({
    "mha/intensity_slope.mha, '2 times the value plus -100, is not applied'",
    "nifti/qform_vs_sform.nii.gz, 'its matrix (sform) is used, not its quaternion (qform)'",
    "nifti/analyze75.hdr, the orientation in the patient is unknown",
    "tiff/ij_stack_pixel.tif, the unit of length is 'pixel'",
    "tiff/folder, '5 files in the order of the numbers in their names, from slice_1.tif to"
        + " slice_11.tif'",
    "tiff/miniswhite8.tif, the values are inverted",
    "tiff/bit1_white0.tif, the values are inverted",
    "nrrd/rgb_4d.nrrd, the voxels are colours",
    "nrrd/overlap.seg.nrrd, 2 layers of segments that may overlap",
    "nifti/rgb24.nii, the voxels are colours",
  })
  void aNoteSaysHowTheFileWasUnderstood(String name, String words) throws Exception {
    List<String> notes = open(name).header().notes();
    assertTrue(
        notes.stream().anyMatch(note -> note.contains(words.replace("''", "'"))),
        () -> notes.toString());
  }

  @ParameterizedTest
  @CsvSource({
    "nrrd/space_RPS.nrrd, right-posterior-superior",
    "nrrd/cmtk_displacement.nrrd, the voxels are vectors of 3 numbers (kind vector)",
    "mha/spatial_object.mha, the ObjectType \"Tube\" is no image",
    "tiff/ome_tc.ome.tif, 2 times of 5 slices in 2 channels",
    "tiff/ij_zct_order.tif, 2 channels of 5 slices",
    "tiff/ij_images_lie.tif, promises 50 slices but the file has room for at most 7",
    "tiff/different_sizes.tif, page 4 has 7x5 pixels of 16 bits but page 1 has 7x6",
  })
  void aRefusalNamesWhatIsUnusual(String name, String words) {
    String message = assertThrows(VolumeFormatException.class, () -> open(name)).getMessage();
    assertTrue(message.contains(words), message);
    assertEquals(1, message.lines().count(), message);
  }

  @Test
  void theMatrixOfANiftiWinsOverItsQuaternion() throws Exception {
    VolumeReader reader = open("nifti/qform_vs_sform.nii.gz");
    assertEquals(CoordinateSystem.RAS, reader.header().coordinateSystem());
    Vec3 far = reader.header().grid().gridToWorld(new Vec3(6.5, 5.5, 4.5), new Vec3());
    assertEquals(52.5032, far.x, 1e-4);
    assertEquals(-92.3081, far.y, 1e-4);
    assertEquals(-90.6340, far.z, 1e-4);
  }

  @Test
  void anAnalyzeVolumeIsFoundByEitherOfItsFilesAndNamesNoAxes() throws Exception {
    for (String name : List.of("nifti/analyze75.hdr", "nifti/analyze75.img")) {
      VolumeReader reader = open(name);
      assertEquals("Analyze 7.5", reader.header().format());
      assertEquals(CoordinateSystem.UNKNOWN, reader.header().coordinateSystem());
      requireValues(reader, PLAIN);
    }
  }

  @ParameterizedTest
  @CsvSource({"tiff/float_pred3_deflate.tif", "tiff/float_pred3_lzw.tif"})
  void theFloatingPointPredictorIsReversed(String name) throws Exception {
    VolumeReader reader = open(name);
    requireValues(reader, (x, y, z) -> PLAIN.of(x, y, z) / 4 - 10);
    assertEquals(109, segment(reader, SegmentSpec.atLeast("b", 45.75)).bits().solidCount());
  }

  @ParameterizedTest
  @CsvSource({"tiff/bit1_black0.tif", "tiff/bit1_white0.tif", "tiff/bit1_fillorder2.tif"})
  void pixelsOfOneBitAreAMask(String name) throws Exception {
    BitCube mask = segment(open(name), SegmentSpec.nonzero("mask")).bits();
    assertEquals(49, mask.solidCount());
    assertEquals("x 0-5, y 0-4, z 0-4", mask.bounds().toString());
  }

  @Test
  void whiteIsTheHighestValueWhereTheFileHasItAsZero() throws Exception {
    VolumeReader reader = open("tiff/miniswhite8.tif");
    requireValues(reader, (x, y, z) -> Math.floor(PLAIN.of(x, y, z) / 2));
    assertEquals(108, segment(reader, SegmentSpec.atLeast("b", 112)).bits().solidCount());
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "1, 500", "2, 1000", "3, 1500"})
  void aTimeAndChannelOfAnOmeTiffAreChosenTogether(int step, int offset) throws Exception {
    requireValues(
        open("tiff/ome_tc.ome.tif", ReadOptions.defaults().withTimeStep(step)),
        (x, y, z) -> PLAIN.of(x, y, z) + offset);
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "1, 500"})
  void aChannelOfAnImagejStackIsChosen(int step, int offset) throws Exception {
    requireValues(
        open("tiff/ij_zct_order.tif", ReadOptions.defaults().withTimeStep(step)),
        (x, y, z) -> PLAIN.of(x, y, z) + offset);
  }

  @Test
  void greyColoursKeepTheirValue() throws Exception {
    requireValues(open("nifti/rgb24.nii"), (x, y, z) -> PLAIN.of(x, y, z) % 256);
  }

  @Test
  void segmentsOfSeveralLayersKeepTheirNamesAndTheirOverlap() throws Exception {
    VolumeReader reader = open("nrrd/overlap.seg.nrrd");
    List<String> names =
        reader.header().labels().get().labels().values().stream().map(l -> l.name()).toList();
    assertEquals(List.of("bone", "left lung: upper", "M\u00fcskel", "tip"), names);
    List<Segment> segments =
        SegmentBuilder.read(
                reader,
                List.of(
                    SegmentSpec.labels("bone", 1),
                    SegmentSpec.labels("lung", 2),
                    SegmentSpec.labels("muscle", 3),
                    SegmentSpec.labels("tip", 4)))
            .segments();
    assertEquals(
        List.of(30L, 18L, 18L, 2L),
        segments.stream().map(segment -> segment.bits().solidCount()).toList());
    assertEquals(8, common(segments.get(0).bits(), segments.get(2).bits()));
  }

  @Test
  void oneLayerIsReadAloneIfItIsChosen() throws Exception {
    VolumeReader reader = open("nrrd/overlap.seg.nrrd", ReadOptions.defaults().withTimeStep(1));
    assertEquals("M\u00fcskel", reader.header().labels().get().labels().get(1L).name());
    assertEquals(18, segment(reader, SegmentSpec.labels("m", 1)).bits().solidCount());
  }

  private static int common(BitCube a, BitCube b) {
    int count = 0;
    for (int n = 0; n < SIZE_X * SIZE_Y * SIZE_Z; n++) {
      int i = n % SIZE_X;
      int j = n / SIZE_X % SIZE_Y;
      int k = n / SIZE_X / SIZE_Y;
      count += a.get(i, j, k) && b.get(i, j, k) ? 1 : 0;
    }
    return count;
  }

  private static void requireValues(VolumeReader reader, Values expected) throws Exception {
    int[] slices = {0};
    reader.read(
        (k, slice) -> {
          slices[0]++;
          requireSlice(k, slice, expected);
        });
    assertEquals(SIZE_Z, slices[0]);
  }

  private static void requireSlice(int k, VoxelSlice slice, Values expected) {
    assertEquals(SIZE_X, slice.sizeX());
    assertEquals(SIZE_Y, slice.sizeY());
    for (int n = 0; n < slice.count(); n++) {
      int x = n % SIZE_X;
      int y = n / SIZE_X;
      assertEquals(expected.of(x, y, k), slice.value(n), () -> x + "," + y + "," + k);
    }
  }

  private static Segment segment(VolumeReader reader, SegmentSpec spec) throws Exception {
    return SegmentBuilder.read(reader, List.of(spec)).segments().get(0);
  }

  private static VolumeReader open(String name) throws VolumeFormatException {
    return open(name, ReadOptions.defaults());
  }

  private static VolumeReader open(String name, ReadOptions options) throws VolumeFormatException {
    return VolumeFiles.open(Scans.file("cases/" + name), options);
  }
}
