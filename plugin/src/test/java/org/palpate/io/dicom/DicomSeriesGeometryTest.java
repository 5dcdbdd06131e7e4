package org.palpate.io.dicom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;

class DicomSeriesGeometryTest {
  private static final String AXIAL = "1\\0\\0\\0\\1\\0";
  private static final String SAGITTAL = "0\\1\\0\\0\\0\\-1";

  @TempDir Path folder;

  @Test
  void sagittalSlicesFollowTheirPositions() throws Exception {
    slices("1.2", SAGITTAL, "30\\1\\2", "27\\1\\2", "33\\1\\2");
    VolumeReader reader = VolumeFiles.open(folder, ReadOptions.defaults());
    // the normal of (0,1,0) x (0,0,-1) is (-1,0,0): from x = 33 down
    Vec3 world = reader.header().grid().gridToWorld(new Vec3(2.5, 3.5, 1.5), new Vec3());
    assertEquals(30, world.x, 1e-12);
    assertEquals(1 + 2 * 0.5, world.y, 1e-12);
    assertEquals(2 - 3 * 0.75, world.z, 1e-12);
    assertEquals(List.of(102, 100, 101), values(reader));
  }

  @Test
  void missingSlicesAreRefusedWithTheGapAndInterpolatedOnRequest() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\0\\2", "0\\0\\4", "0\\0\\8");
    String message = refusal(ReadOptions.defaults());
    assertTrue(message.contains("1 slice(s) missing: between 4 and 8 mm"), message);
    assertTrue(message.contains("--resample"), message);
    VolumeReader reader = VolumeFiles.open(folder, ReadOptions.defaults().withResample(true));
    assertEquals(2, reader.header().grid().spacingMm().z, 1e-12);
    // half way between 102 and 103 is rounded to even
    assertEquals(List.of(100, 101, 102, 102, 103), values(reader));
    assertTrue(reader.header().notes().get(0).contains("resampled"));
  }

  @Test
  void unevenSpacingIsRefusedWithNumbers() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\0\\2", "0\\0\\4", "0\\0\\6.5");
    String message = refusal(ReadOptions.defaults());
    assertTrue(
        message.contains("uneven: between 4 and 6.5 mm the gap is 2.5 mm instead of 2 mm"),
        message);
  }

  @Test
  void aTiltedGantryIsRefusedWithItsAngle() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\1\\2", "0\\2\\4");
    assertTrue(refusal(ReadOptions.defaults()).contains("tilted by 26.57 degrees"));
    assertThrows(
        VolumeFormatException.class,
        () -> VolumeFiles.open(folder, ReadOptions.defaults().withResample(true)));
  }

  @Test
  void twoSlicesWithOnePositionAreRefused() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\0\\2", "0\\0\\2");
    String message = refusal(ReadOptions.defaults());
    assertTrue(message.contains("at z = 2 mm (1.2-1.dcm, 1.2-2.dcm)"), message);
  }

  @Test
  void aSingleSliceIsAsThickAsItsHeaderStates() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0");
    VolumeReader reader = VolumeFiles.open(folder, ReadOptions.defaults());
    assertEquals(9, reader.header().grid().spacingMm().z, 1e-12);
    assertEquals(
        List.of("a single slice: the slice spacing is its thickness"), reader.header().notes());
  }

  @Test
  void seriesAreListedByNumberAndChosenByNumberOrUid() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\0\\2");
    slices("1.3", AXIAL, "0\\0\\0", "0\\0\\3", "0\\0\\6");
    String message = refusal(ReadOptions.defaults());
    assertTrue(message.contains("1 CT, 2 files of 6x5; 2 CT, 3 files of 6x5"), message);
    assertEquals(
        3,
        VolumeFiles.open(folder, ReadOptions.defaults().withSeries("2")).header().grid().sizeZ());
    assertEquals(
        2,
        VolumeFiles.open(folder, ReadOptions.defaults().withSeries("1.2")).header().grid().sizeZ());
    assertTrue(refusal(ReadOptions.defaults().withSeries("7")).contains("no series '7'"));
  }

  @Test
  void headerAndMessageDoNotIdentifyThePatient() throws Exception {
    slices("1.2", AXIAL, "0\\0\\0", "0\\0\\2");
    String header = VolumeFiles.open(folder, ReadOptions.defaults()).header().toString();
    assertFalse(header.contains("Secret"), header);
    slices("1.3", AXIAL, "0\\0\\0", "0\\0\\3");
    assertFalse(refusal(ReadOptions.defaults()).contains("Secret"));
  }

  @Test
  void losslessJpegIsReadPixelForPixel() throws Exception {
    // written with imagecodecs 2026.3.6 and pydicom 3.0.2; crc32 of the pixels that went in
    Path file = folder.resolve("ljpeg.dcm");
    try (InputStream in =
        DicomSeriesGeometryTest.class.getResourceAsStream("/org/palpate/io/ljpeg.dcm")) {
      Files.copy(in, file);
    }
    assertEquals("e431c987", VoxelCrc.of(VolumeFiles.open(file, ReadOptions.defaults())));
  }

  /**
   * Writes slices of values 100, 101, ... whose file names are in another order than their
   * positions.
   */
  private void slices(String uid, String orientation, String... positions) throws Exception {
    for (int n = 0; n < positions.length; n++) {
      Path file = folder.resolve(uid + "-" + (positions.length - n) + ".dcm");
      DicomSliceWriter.slice(file, uid, positions[n], orientation, 100 + n);
    }
  }

  private String refusal(ReadOptions options) {
    return assertThrows(VolumeFormatException.class, () -> VolumeFiles.open(folder, options))
        .getMessage();
  }

  private static List<Integer> values(VolumeReader reader) throws VolumeFormatException {
    List<Integer> values = new ArrayList<>();
    reader.read((k, slice) -> values.add(slice.integers()[7]));
    return values;
  }
}
