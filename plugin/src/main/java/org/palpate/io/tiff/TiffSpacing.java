package org.palpate.io.tiff;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;

/** Finds the spacing of a TIFF stack, and notes what is not known of it. */
final class TiffSpacing {
  private static final int NO_UNIT = 1;
  private static final int CENTIMETRE = 3;

  private TiffSpacing() {}

  /** Returns the spacing that OME-XML, else ImageJ, else the resolution of the page states, mm. */
  static Vec3 of(
      TiffPage first, ImagejDescription imagej, Optional<OmeXml> ome, List<String> notes) {
    return ome.map(xml -> ofOme(xml, notes)).orElseGet(() -> ofTags(first, imagej, notes));
  }

  private static Vec3 ofOme(OmeXml ome, List<String> notes) {
    double x = ome.spacingMm(0);
    double y = ome.spacingMm(1);
    if (Double.isNaN(x) || Double.isNaN(y)) {
      notes.add("the OME-XML states no pixel size in a unit of length: 1 mm assumed");
      x = 1;
      y = 1;
    }
    return withSliceSpacing(x, y, ome.spacingMm(2), notes);
  }

  private static Vec3 ofTags(TiffPage first, ImagejDescription imagej, List<String> notes) {
    double x = 1 / first.resolution(282);
    double y = 1 / first.resolution(283);
    double mm = imagej.mmPerUnit();
    boolean stated = isSize(x) && isSize(y);
    if (Double.isNaN(mm) && !imagej.isImagej() && first.resolutionUnit() == CENTIMETRE) {
      mm = 10;
    }
    if (!stated) {
      notes.add("the pixel size is unknown: 1 mm assumed");
      x = 1;
      y = 1;
      mm = 1;
    } else if (Double.isNaN(mm) && (imagej.isImagej() || first.resolutionUnit() == NO_UNIT)) {
      notes.add(
          "the unit of length is "
              + (imagej.unit().isEmpty() ? "not stated" : "'" + imagej.unit() + "'")
              + ": the ratio of the spacings is kept, and one unit is taken as 1 mm");
      mm = 1;
    } else if (Double.isNaN(mm)) {
      notes.add("the resolution is one for printing: the pixels are taken as 1 mm wide");
      y = y / x;
      x = 1;
      mm = 1;
    }
    return withSliceSpacing(x * mm, y * mm, sliceSpacing(imagej, mm, notes), notes);
  }

  private static double sliceSpacing(ImagejDescription imagej, double mm, List<String> notes) {
    double spacing = imagej.spacing();
    if (Double.isNaN(spacing) && imagej.isImagej()) {
      return mm; // ImageJ leaves out a spacing of one unit
    }
    if (spacing < 0) {
      notes.add(
          String.format(
              Locale.ROOT,
              "the slice spacing is stated as %s: its size is used",
              NumberText.display(spacing)));
    }
    return Math.abs(spacing) * mm;
  }

  private static Vec3 withSliceSpacing(double x, double y, double z, List<String> notes) {
    if (!isSize(z)) {
      notes.add("the slice spacing is unknown: taken to be the pixel spacing");
      return new Vec3(x, y, x);
    }
    return new Vec3(x, y, z);
  }

  private static boolean isSize(double size) {
    return size > 0 && !Double.isInfinite(size);
  }
}
