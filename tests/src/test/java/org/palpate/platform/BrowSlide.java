package org.palpate.platform;

import ij.IJ;
import ij.ImagePlus;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** A trajectory over the brow of CThead, from one temple to the other, for a picture. */
final class BrowSlide {
  /** The slice, from 1, in which the hand comes to rest. */
  static final int LAST_SLICE = 90;

  private static final int BONE = 1500;
  private static final double X_MM = 111;
  private static final double Y_MM = 131;
  private static final double Z_MM = 176;
  private static final double SLICE_MM = 2;
  private static final double OUTSIDE_MM = 140;
  private static final double PRESSED_MM = 6;
  private static final int APPROACH_MS = 1500;
  private static final int SLIDE_MS = 12_000;
  private static final int SMOOTHED_MS = 250;
  private static final int ALL_MS = 60_000;

  private BrowSlide() {}

  /** Returns the rows of the trajectory for a stack whose slices run from the jaw to the head. */
  static List<String> rows(Path stack) {
    ImagePlus head = IJ.openImage(stack.toString());
    int count = APPROACH_MS + SLIDE_MS;
    double[] reach = new double[count];
    for (int t = 0; t < count; t++) {
      reach[t] = surface(head, angle(t), height(t));
    }
    List<String> rows = new ArrayList<>(List.of("t_ms,x,y,z"));
    for (int t = 0; t < ALL_MS; t++) {
      int at = Math.min(t, count - 1);
      double out = smoothed(reach, at) - PRESSED_MM + Math.max(0, APPROACH_MS - at) * 0.03;
      double x = X_MM + out * StrictMath.cos(angle(at));
      double y = Y_MM + out * StrictMath.sin(angle(at));
      rows.add(String.format(Locale.ROOT, "%d,%.4f,%.4f,%.4f", t, x, y, height(at)));
    }
    return rows;
  }

  private static double fraction(int t) {
    return Math.max(0, t - APPROACH_MS) / (double) SLIDE_MS;
  }

  private static double angle(int t) {
    return -StrictMath.PI / 2 - 0.55 + 1.25 * fraction(t);
  }

  private static double height(int t) {
    return Z_MM - 14 * StrictMath.sin(StrictMath.PI * fraction(t));
  }

  /** Returns the distance of the outermost bone from the middle. */
  private static double surface(ImagePlus head, double angle, double zMm) {
    double out = OUTSIDE_MM;
    while (out > 0 && !isBone(head, angle, out, zMm)) {
      out -= 0.25;
    }
    return out;
  }

  private static boolean isBone(ImagePlus head, double angle, double out, double zMm) {
    int i = (int) (X_MM + out * StrictMath.cos(angle));
    int j = (int) (Y_MM + out * StrictMath.sin(angle));
    int k = (int) (zMm / SLICE_MM) + 1;
    boolean inside = i >= 0 && j >= 0 && i < head.getWidth() && j < head.getHeight();
    return inside && head.getStack().getProcessor(k).get(i, j) >= BONE;
  }

  private static double smoothed(double[] values, int at) {
    int low = Math.max(0, at - SMOOTHED_MS);
    int high = Math.min(values.length, at + SMOOTHED_MS);
    double sum = 0;
    for (int t = low; t < high; t++) {
      sum += values[t];
    }
    return sum / (high - low);
  }
}
