package org.palpate.imagej.stack;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.ImagePlus;
import ij.io.FileSaver;
import ij.measure.Calibration;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.testing.Scans;

/** Checks that a volume becomes a stack of ImageJ with everything that ImageJ can hold of it. */
class VolumeImageTest {
  /** ImageJ saves pixels a mm with six decimals. */
  private static final double IMAGEJ_ROUNDING = 3e-6;

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({
    "CThead/CThead_u16gz.nrrd, 1",
    "LIDC/dicom_10slices, 1",
    "formats/mha/nucleon.mha, 0",
    "cases/tiff/float_pred3_deflate.tif, 2",
    "totalseg/example_seg_fast_force_split.nii.gz, 0",
  })
  void noVoxelAndNoSpacingIsLostOnTheWayThroughImagej(String name, int type) throws Exception {
    Path file = Scans.file(name);
    VolumeReader volume = VolumeFiles.open(file, ReadOptions.defaults());
    ImagePlus image = VolumeImage.read(volume, file);
    assertEquals(type, image.getType());
    assertEquals("mm", image.getCalibration().getUnit());
    Path saved = folder.resolve("saved.tif");
    new FileSaver(image).saveAsTiffStack(saved.toString());
    VolumeReader back = VolumeFiles.open(saved, ReadOptions.defaults());
    assertEquals(VoxelCrc.of(volume), VoxelCrc.of(back));
    Vec3 spacing = volume.header().grid().spacingMm();
    assertEquals(spacing.x, image.getCalibration().pixelWidth);
    assertEquals(spacing.z, image.getCalibration().pixelDepth);
    Vec3 after = back.header().grid().spacingMm();
    assertEquals(spacing.x, after.x, IMAGEJ_ROUNDING * spacing.x);
    assertEquals(spacing.z, after.z);
  }

  @Test
  void labelsKeepTheirNamesColoursAndOrigin() throws Exception {
    Path file = Scans.file("cases/nrrd/overlap.seg.nrrd");
    ImagePlus image = VolumeImage.read(VolumeFiles.open(file, ReadOptions.defaults()), file);
    StackVolume stack = StackVolume.shownIn(image);
    assertEquals("bone", stack.labelTable().labels().get(1L).name());
    SegmentRange tip = SegmentRange.label(4, image, stack.labelTable());
    assertEquals("tip", tip.name());
    assertEquals(stack.labelTable().labels().get(4L).rgb(), tip.rgb());
    Calibration calibration = image.getCalibration();
    assertEquals(0.75, calibration.pixelHeight);
    assertEquals(0, calibration.getX(0.5), 1e-12);
    String info = (String) image.getProperty("Info");
    assertTrue(info.contains("Label 2: left lung: upper"), info);
    assertTrue(info.contains("Note: 2 layers of segments"), info);
  }
}
