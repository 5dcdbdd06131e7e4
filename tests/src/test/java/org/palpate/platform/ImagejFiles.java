package org.palpate.platform;

import ij.ImagePlus;
import ij.ImageStack;
import ij.io.FileSaver;
import ij.process.ByteProcessor;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Makes the files that the probe opens: a ball as a stack, and trajectories. */
final class ImagejFiles {
  static final int EDGE = 64;
  private static final double RADIUS = 20;
  private static final double SPACING_MM = 0.5;

  private ImagejFiles() {}

  /** Writes a ball of value 200 in voxels of half a millimetre; returns the number of voxels. */
  static long writeBall(Path file) {
    ImageStack slices = new ImageStack(EDGE, EDGE);
    long solid = 0;
    for (int k = 0; k < EDGE; k++) {
      ByteProcessor slice = new ByteProcessor(EDGE, EDGE);
      for (int n = 0; n < EDGE * EDGE; n++) {
        if (isInBall(n % EDGE, n / EDGE, k)) {
          slice.set(n, 200);
          solid++;
        }
      }
      slices.addSlice(slice);
    }
    ImagePlus image = new ImagePlus("ball", slices);
    image.getCalibration().setUnit("mm");
    image.getCalibration().pixelWidth = SPACING_MM;
    image.getCalibration().pixelHeight = SPACING_MM;
    image.getCalibration().pixelDepth = SPACING_MM;
    new FileSaver(image).saveAsTiffStack(file.toString());
    return solid;
  }

  private static boolean isInBall(int i, int j, int k) {
    double x = i + 0.5 - EDGE / 2.0;
    double y = j + 0.5 - EDGE / 2.0;
    double z = k + 0.5 - EDGE / 2.0;
    return x * x + y * y + z * z <= RADIUS * RADIUS;
  }

  /** Writes a trajectory that circles for a minute slightly below the ball's surface. */
  static void writeSlide(Path file) throws IOException {
    List<String> rows = new ArrayList<>(List.of("t_ms,x,y,z"));
    double reach = (RADIUS - 2) * SPACING_MM;
    double middle = EDGE / 2.0 * SPACING_MM;
    for (int n = 0; n < 60_000; n++) {
      double out = n < 1000 ? reach + (1000 - n) * 0.005 : reach;
      double x = middle + out * StrictMath.cos(n * 0.001);
      double y = middle + out * StrictMath.sin(n * 0.001);
      rows.add(String.format(Locale.ROOT, "%d,%.6f,%.6f,%.6f", n, x, y, middle));
    }
    Files.write(file, rows);
  }

  /** Writes a trajectory that rests beside the ball. */
  static void writeStill(Path file, int millis) throws IOException {
    List<String> rows = new ArrayList<>(List.of("t_ms,x,y,z"));
    double middle = EDGE / 2.0 * SPACING_MM;
    for (int n = 0; n < millis; n++) {
      rows.add(String.format(Locale.ROOT, "%d,%.6f,%.6f,%.6f", n, 1.0, middle, middle));
    }
    Files.write(file, rows);
  }

  /** Writes a segmentation of 4x4x8 voxels with two named labels, as 3D Slicer does. */
  static void writeLabels(Path file) throws IOException {
    JawLabels.write(file, 4, "left-posterior-superior", "(0.5,0,0) (0,0.8,0) (0,0,2)", "");
  }
}
