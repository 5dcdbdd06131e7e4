package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;
import ij.measure.Calibration;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.Vec3;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelCrc;
import org.palpate.testing.Scans;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.Phantom;

/** Exchanges volumes with ImageJ by its own TIFF: no voxel and no calibration is lost. */
class ImagejExchangeTest {
  @TempDir Path folder;

  @Test
  void aHeadGoesThroughImagejAndComesBackEqual() throws Exception {
    VolumeReader head =
        VolumeFiles.open(Scans.file("CThead/CThead_u16gz.nrrd"), ReadOptions.defaults());
    requireRoundTrip(head, ImagePlus.GRAY16);
  }

  @Test
  void signedValuesAndOddSpacingsComeBackEqual() throws Exception {
    VolumeReader chest =
        VolumeFiles.open(Scans.file("LIDC/dicom_10slices"), ReadOptions.defaults());
    requireRoundTrip(chest, ImagePlus.GRAY16);
    VolumeReader body =
        VolumeFiles.open(Scans.file("formats/nifti/anatomical.nii"), ReadOptions.defaults());
    requireRoundTrip(body, ImagePlus.GRAY16);
  }

  @Test
  void floatsComeBackEqual() throws Exception {
    VolumeReader floats =
        VolumeFiles.open(Scans.file("cases/tiff/float_pred3_deflate.tif"), ReadOptions.defaults());
    requireRoundTrip(floats, ImagePlus.GRAY32);
  }

  @Test
  void labelsBecomeBytes() throws Exception {
    requireRoundTrip(
        new SegmentsAsLabels(Phantom.parse("head:32").segments(), CoordinateSystem.UNKNOWN),
        ImagePlus.GRAY8);
  }

  /** Writes a TIFF, opens it in ImageJ, saves it there, and reads that. */
  private void requireRoundTrip(VolumeReader volume, int type) throws Exception {
    Path written = folder.resolve("written.tif");
    String words = VolumeWriter.write(volume, written);
    assertTrue(words.startsWith("TIFF of ImageJ"), words);
    requireSame(volume, VolumeFiles.open(written, ReadOptions.defaults()));
    ImagePlus image = IJ.openImage(written.toString());
    assertEquals(type, image.getType());
    requireCalibration(volume.header().grid(), image);
    requireValues(volume, image);
    Path saved = folder.resolve("saved.tif");
    new FileSaver(image).saveAsTiffStack(saved.toString());
    requireSame(volume, VolumeFiles.open(saved, ReadOptions.defaults()));
  }

  private static void requireCalibration(VoxelGrid grid, ImagePlus image) {
    Calibration calibration = image.getCalibration();
    assertEquals(grid.sizeZ(), image.getNSlices());
    assertEquals("mm", calibration.getUnit());
    assertEquals(grid.spacingMm().x, calibration.pixelWidth);
    assertEquals(grid.spacingMm().y, calibration.pixelHeight);
    assertEquals(grid.spacingMm().z, calibration.pixelDepth);
    if (grid.gridMmToWorld().axisX().x == 1 && grid.gridMmToWorld().axisY().y == 1) {
      Vec3 centre = grid.gridToWorld(new Vec3(0.5, 0.5, 0.5), new Vec3());
      assertEquals(centre.x, calibration.getX(0.5), 1e-9);
      assertEquals(centre.y, calibration.getY(0.5), 1e-9);
      assertEquals(centre.z, calibration.getZ(0.5), 1e-9);
    }
  }

  private static void requireValues(VolumeReader volume, ImagePlus image) throws Exception {
    Calibration calibration = image.getCalibration();
    volume.read(
        (k, slice) -> {
          for (int n : List.of(0, slice.count() / 2, slice.count() - 1)) {
            int x = n % slice.sizeX();
            float raw = image.getStack().getProcessor(k + 1).getf(x, n / slice.sizeX());
            assertEquals(slice.value(n), calibration.getCValue((double) raw));
          }
        });
  }

  private static void requireSame(VolumeReader expected, VolumeReader actual) throws Exception {
    assertEquals(VoxelCrc.of(expected), VoxelCrc.of(actual));
    Vec3 spacing = expected.header().grid().spacingMm();
    assertEquals(spacing.toString(), actual.header().grid().spacingMm().toString());
  }
}
