package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;

/** Reads the small unusual DICOM files of {@code cases/dicom}; its README states what is right. */
class DicomCasesTest {
  private static final double TOLERANCE = 1e-9;
  private static final ReadOptions ANY = ReadOptions.defaults();

  @ParameterizedTest
  @ValueSource(
      strings = {
        "duplicates_identical",
        "with_strangers",
        "no_preamble",
        "multiframe_ct_nopos.dcm"
      })
  void theSameScanIsReadWhateverIsSpecial(String name) throws Exception {
    VolumeReader reader = open(name, ANY);
    requireGrid(reader);
    requireValues(reader, -1024, -568, -167_160);
    requireWorld(reader, -7, -16.25, 38);
    assertEquals(109, voxels(reader, SegmentSpec.atLeast("a", -801)).solidCount());
    assertEquals("x 0-6, y 0-5, z 2-4", bounds(reader, SegmentSpec.atLeast("a", -801)));
    assertEquals(2, voxels(reader, SegmentSpec.atLeast("a", -569)).solidCount());
  }

  @Test
  void copiesAreDroppedWithANote() throws Exception {
    requireNote(open("duplicates_identical", ANY), "copy of im1.dcm, copy of im3.dcm");
  }

  @Test
  void strangersAreSetAsideWithANote() throws Exception {
    requireNote(open("with_strangers", ANY), "DICOMDIR, README.txt, Thumbs.db, empty, report.pdf");
  }

  @Test
  void framesWithoutPositionsAreStackedWithANote() throws Exception {
    requireNote(open("multiframe_ct_nopos.dcm", ANY), "2 mm apart (SpacingBetweenSlices)");
  }

  @Test
  void twoReconstructionsInOneSeriesAreRefusedWithPositionsAndFiles() {
    assertTrue(
        refusal("duplicates_other_pixels")
            .contains("z = 32 mm (im2.dcm, x1.dcm) and z = 36 mm (im4.dcm, x3.dcm)"),
        refusal("duplicates_other_pixels"));
  }

  @Test
  void aPositionWithoutPixelSpacingIsRefused() {
    assertTrue(refusal("no_pixelspacing").contains("no PixelSpacing"), refusal("no_pixelspacing"));
  }

  @Test
  void subFoldersAreNamed() {
    assertTrue(refusal("subfolders").contains("s0, s1"), refusal("subfolders"));
  }

  @Test
  void timesAreListedAndOneIsRead() throws Exception {
    assertTrue(
        refusal("time_series").contains("3 times (1, 2, 3), each of 5 slices"),
        refusal("time_series"));
    VolumeReader first = open("time_series", ANY.withTimeStep(0));
    requireGrid(first);
    requireValues(first, 0, 456, 47_880);
    assertEquals(109, voxels(first, SegmentSpec.atLeast("a", 223)).solidCount());
    assertEquals(2000, values(open("time_series", ANY.withTimeStep(2)))[0], TOLERANCE);
  }

  @Test
  void doseIsReadInGray() throws Exception {
    VolumeReader reader = open("rtdose.dcm", ANY);
    requireGrid(reader);
    requireValues(reader, 0, 4.56, 478.8);
    assertEquals(109, voxels(reader, SegmentSpec.atLeast("a", 2.23)).solidCount());
    assertEquals("x 0-6, y 0-5, z 2-4", bounds(reader, SegmentSpec.atLeast("a", 2.23)));
    requireNote(reader, "Gy");
  }

  @ParameterizedTest
  @ValueSource(strings = {"seg_binary.dcm", "seg_fractional.dcm"})
  void segmentsAreReadWholeWithTheSlicesThatHaveNoFrame(String name) throws Exception {
    VolumeReader reader = open(name, ANY);
    requireGrid(reader);
    BitCube bone = voxels(reader, SegmentSpec.parse("a=name:bone"));
    BitCube lung = voxels(reader, SegmentSpec.parse("a=label:2"));
    assertEquals(List.of(24L, 19L), List.of(bone.solidCount(), lung.solidCount()));
    assertEquals(List.of(true, true, false, true, true), slices(bone));
    assertEquals(List.of(false, true, true, true, false), slices(lung));
    // they share one voxel
    assertEquals(24 + 19 - 1, voxels(reader, SegmentSpec.nonzero("a")).solidCount());
    assertEquals("bone", reader.header().labels().orElseThrow().labels().get(1L).name());
    requireWorld(reader, -7, -16.25, 38);
  }

  @Test
  void aLabelMapIsReadAsLabels() throws Exception {
    VolumeReader reader = open("seg_labelmap.dcm", ANY);
    requireGrid(reader);
    assertEquals(30, voxels(reader, SegmentSpec.labels("a", 1)).solidCount());
    assertEquals(19, voxels(reader, SegmentSpec.labels("a", 2)).solidCount());
  }

  private static void requireGrid(VolumeReader reader) {
    assertEquals(7, reader.header().grid().sizeX());
    assertEquals(6, reader.header().grid().sizeY());
    assertEquals(5, reader.header().grid().sizeZ());
    Vec3 spacing = reader.header().grid().spacingMm();
    assertEquals(0.5, spacing.x, TOLERANCE);
    assertEquals(0.75, spacing.y, TOLERANCE);
    assertEquals(2, spacing.z, TOLERANCE);
  }

  private static void requireWorld(VolumeReader reader, double x, double y, double z) {
    Vec3 world = reader.header().grid().gridToWorld(new Vec3(6.5, 5.5, 4.5), new Vec3());
    assertEquals(x, world.x, TOLERANCE);
    assertEquals(y, world.y, TOLERANCE);
    assertEquals(z, world.z, TOLERANCE);
  }

  private static void requireValues(VolumeReader reader, double low, double high, double sum)
      throws VolumeFormatException {
    double[] found = values(reader);
    assertEquals(low, found[0], TOLERANCE);
    assertEquals(high, found[1], TOLERANCE);
    assertEquals(sum, found[2], TOLERANCE);
  }

  /** Returns the least value, the largest, and the sum. */
  private static double[] values(VolumeReader reader) throws VolumeFormatException {
    double[] found = {Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, 0};
    reader.read(
        (k, slice) -> {
          for (int n = 0; n < slice.count(); n++) {
            found[0] = Math.min(found[0], slice.value(n));
            found[1] = Math.max(found[1], slice.value(n));
            found[2] += slice.value(n);
          }
        });
    return found;
  }

  private static List<Boolean> slices(BitCube bits) {
    Boolean[] filled = {false, false, false, false, false};
    for (int k = 0; k < 5; k++) {
      for (int n = 0; n < 42; n++) {
        filled[k] |= bits.get(n % 7, n / 7, k);
      }
    }
    return List.of(filled);
  }

  private static String bounds(VolumeReader reader, SegmentSpec spec) throws VolumeFormatException {
    return voxels(reader, spec).bounds().toString();
  }

  private static BitCube voxels(VolumeReader reader, SegmentSpec spec)
      throws VolumeFormatException {
    return SegmentBuilder.read(reader, List.of(spec)).segments().get(0).bits();
  }

  private static void requireNote(VolumeReader reader, String says) {
    List<String> notes = reader.header().notes();
    assertTrue(notes.stream().anyMatch(note -> note.contains(says)), notes.toString());
  }

  private static String refusal(String name) {
    VolumeFormatException refused =
        assertThrows(VolumeFormatException.class, () -> open(name, ANY));
    assertEquals(1, refused.getMessage().lines().count());
    return refused.getMessage();
  }

  private static VolumeReader open(String name, ReadOptions options) throws VolumeFormatException {
    return VolumeFiles.open(Scans.file("cases/dicom/" + name), options);
  }
}
