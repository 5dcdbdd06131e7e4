package org.palpate.io.tiff;

import static org.junit.jupiter.api.Assertions.assertEquals;

import ij.IJ;
import ij.ImagePlus;
import ij.io.FileSaver;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.io.volume.ReadOptions;

class ImagejUnitTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({
    "mm, 1",
    "CM, 10",
    "m, 1000",
    "inches, 25.4",
    "in, 25.4",
    "\u00b5m, 1e-3",
    "nm, 1e-6"
  })
  void aStackHasTheSameSpacingInImagejAndInItsFile(String unit, double mm) throws Exception {
    ImagePlus image = IJ.createImage("stack", "8-bit black", 2, 2, 2);
    image.getCalibration().setUnit(unit);
    image.getCalibration().pixelWidth = 0.5;
    image.getCalibration().pixelHeight = 0.25;
    image.getCalibration().pixelDepth = 2;
    Path file = folder.resolve("stack.tif");
    new FileSaver(image).saveAsTiffStack(file.toString());
    Vec3 read = TiffReader.open(file, ReadOptions.defaults()).header().grid().spacingMm();
    assertEquals(new Vec3(0.5 * mm, 0.25 * mm, 2 * mm).toString(), read.toString());
    assertEquals(read.toString(), StackGeometry.of(image).grid().spacingMm().toString());
  }

  @Test
  void aNameOfNoLengthHasNone() {
    assertEquals(Double.NaN, ImagejUnit.mm("pixel"));
    assertEquals(Double.NaN, ImagejUnit.mm(""));
  }
}
