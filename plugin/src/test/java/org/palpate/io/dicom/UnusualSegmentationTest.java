package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Reads segmentation objects made here, of 4x3 pixels and one byte a pixel. */
class UnusualSegmentationTest {
  private static final double TOLERANCE = 1e-9;
  private static final int PIXELS = DicomTestFile.COLUMNS * DicomTestFile.ROWS;

  @TempDir Path folder;

  @Test
  void aSegmentInsideAnotherIsNotLost() throws Exception {
    byte[] pixels = new byte[2 * PIXELS];
    Arrays.fill(pixels, (byte) 1);
    VolumeReader reader = read(segmentation("BINARY", pixels, frame(2, 0), frame(1, 0)));
    assertEquals(List.of(12L, 12L), voxels(reader));
  }

  @Test
  void halfOfTheMaximumBelongsToASegmentAndLessDoesNot() throws Exception {
    byte[] pixels = new byte[PIXELS];
    pixels[0] = (byte) 200;
    pixels[1] = (byte) 100;
    pixels[2] = (byte) 99;
    VolumeReader reader =
        read(segmentation("FRACTIONAL", pixels, frame(1, 0)).number(DicomTag.MOST_FRACTION, 200));
    assertEquals(2, voxels(reader).get(0));
  }

  @Test
  void aLabelMapMayHaveAPaletteAndAnotherBackground() throws Exception {
    byte[] pixels = {9, 9, 1, 1, 2, 9, 9, 9, 9, 9, 9, 9};
    VolumeReader reader =
        read(
            segmentation("LABELMAP", pixels, frame(0, 0))
                .text(DicomTag.PHOTOMETRIC, "CS", "PALETTE COLOR")
                .number(DicomTag.PADDING, 9));
    assertEquals(List.of(2L, 1L), voxels(reader));
  }

  @Test
  void theStatedSpacingCountsIfAllPositionsFitIt() throws Exception {
    VolumeReader reader =
        read(segmentation("BINARY", new byte[2 * PIXELS], frame(1, 10), frame(1, 16)));
    assertEquals(4, reader.header().grid().sizeZ()); // two slices between have no frame
    assertEquals(2, reader.header().grid().spacingMm().z, TOLERANCE);
  }

  @Test
  void theLeastDistanceCountsIfTheStatedSpacingDoesNotFit() throws Exception {
    VolumeReader reader =
        read(segmentation("BINARY", new byte[3 * PIXELS], frame(1, 3), frame(1, -3), frame(2, 0)));
    assertEquals(3, reader.header().grid().sizeZ());
    assertEquals(3, reader.header().grid().spacingMm().z, TOLERANCE);
    Vec3 first = reader.header().grid().gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
    assertEquals(-3, first.z, TOLERANCE);
  }

  @Test
  void unevenPositionsAreRefused() throws Exception {
    requireRefusal(
        segmentation("BINARY", new byte[3 * PIXELS], frame(1, 0), frame(1, 3), frame(1, 7.1)),
        "spaced unevenly");
  }

  @Test
  void framesFarApartAreRefusedBeforeTheirSlicesAreMade() throws Exception {
    requireRefusal(
        segmentation("BINARY", new byte[2 * PIXELS], frame(1, 0), frame(1, 2e6)),
        "2000000 mm apart");
  }

  @Test
  void aFrameOfAnUnknownSegmentIsRefused() throws Exception {
    requireRefusal(segmentation("BINARY", new byte[PIXELS], frame(3, 0)), "shows segment 3");
  }

  @Test
  void framesWithoutPositionAreRefused() throws Exception {
    requireRefusal(
        segmentation("BINARY", new byte[2 * PIXELS], shows(1), frame(1, 0)), "no position");
  }

  @Test
  void aSegmentWithoutFrameIsNamed() throws Exception {
    VolumeReader reader = read(segmentation("BINARY", new byte[PIXELS], frame(1, 0)));
    assertTrue(reader.header().notes().toString().contains("without a voxel: Müskel"));
  }

  @Test
  void namesAreDecodedByTheCharacterSet() throws Exception {
    byte[] latin = "Müskel".getBytes(StandardCharsets.ISO_8859_1);
    DicomElements segment =
        new DicomElements()
            .shorts(DicomTag.SEGMENT_NUMBER, 1)
            .value(DicomTag.SEGMENT_LABEL, "LO", latin);
    VolumeReader reader =
        read(
            segmentation("BINARY", new byte[PIXELS], frame(1, 0))
                .text(DicomTag.CHARACTER_SET, "CS", "ISO_IR 100")
                .sequence(DicomTag.SEGMENT_SEQUENCE, segment));
    assertEquals("Müskel", reader.header().labels().orElseThrow().labels().get(1L).name());
  }

  private static DicomTestFile segmentation(String kind, byte[] pixels, DicomElements... frames) {
    DicomElements[] segments = {segment(1, "bone"), segment(2, "Müskel")};
    DicomElements measures =
        new DicomElements()
            .text(DicomTag.SLICE_SPACING, "DS", "2")
            .text(DicomTag.PIXEL_SPACING, "DS", "1\\1");
    return new DicomTestFile(0, 0)
        .without(DicomTag.POSITION)
        .text(DicomTag.CHARACTER_SET, "CS", "ISO_IR 192")
        .text(DicomTag.MODALITY, "CS", "SEG")
        .text(DicomTag.FRAMES, "IS", Integer.toString(frames.length))
        .text(DicomTag.SEGMENTATION_KIND, "CS", kind)
        .sequence(DicomTag.SEGMENT_SEQUENCE, segments)
        .sequence(
            DicomTag.SHARED_GROUPS,
            new DicomElements().sequence(DicomTag.PIXEL_MEASURES_SEQUENCE, measures))
        .sequence(DicomTag.FRAME_GROUPS, frames)
        .bytes(pixels);
  }

  private static DicomElements segment(int number, String name) {
    return new DicomElements()
        .shorts(DicomTag.SEGMENT_NUMBER, number)
        .text(DicomTag.SEGMENT_LABEL, "LO", name);
  }

  private static DicomElements frame(int segment, double z) {
    return new DicomElements()
        .sequence(
            DicomTag.PLANE_POSITION_SEQUENCE,
            new DicomElements().text(DicomTag.POSITION, "DS", "0\\0\\" + z))
        .sequence(
            DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE,
            new DicomElements().shorts(DicomTag.REFERENCED_SEGMENT, segment));
  }

  /** Returns the groups of a frame that shows a segment nowhere. */
  private static DicomElements shows(int segment) {
    return new DicomElements()
        .sequence(
            DicomTag.SEGMENT_IDENTIFICATION_SEQUENCE,
            new DicomElements().shorts(DicomTag.REFERENCED_SEGMENT, segment));
  }

  /** Returns the voxels of segments 1 and 2. */
  private static List<Long> voxels(VolumeReader reader) throws VolumeFormatException {
    List<Long> voxels = new ArrayList<>();
    for (long label = 1; label <= 2; label++) {
      List<SegmentSpec> spec = List.of(SegmentSpec.labels("a", label));
      voxels.add(SegmentBuilder.read(reader, spec).segments().get(0).bits().solidCount());
    }
    return voxels;
  }

  private VolumeReader read(DicomTestFile file) throws Exception {
    return VolumeFiles.open(file.write(folder.resolve("seg.dcm")), ReadOptions.defaults());
  }

  private void requireRefusal(DicomTestFile file, String says) throws Exception {
    Path path = file.write(folder.resolve("seg.dcm"));
    VolumeFormatException refused =
        assertThrows(
            VolumeFormatException.class, () -> VolumeFiles.open(path, ReadOptions.defaults()));
    assertTrue(refused.getMessage().contains(says), refused.getMessage());
  }
}
