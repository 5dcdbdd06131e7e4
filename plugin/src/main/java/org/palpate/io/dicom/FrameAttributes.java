package org.palpate.io.dicom;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.dicom.DicomFrame.ImagePlane;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Looks up the attributes of a frame: first its own, then the shared ones, then those of the file.
 *
 * <p>Source: DICOM PS3.3, C.7.6.16.
 *
 * @param dicom the file
 * @param own the functional groups of the frame
 * @param shared the functional groups of all frames
 */
record FrameAttributes(DicomFile dicom, DicomDataSet own, DicomDataSet shared) {

  /** Returns the attributes of each frame of a file. */
  static List<FrameAttributes> of(DicomFile dicom, int count) {
    List<DicomDataSet> groups = dicom.attributes().items(DicomTag.FRAME_GROUPS);
    List<DicomDataSet> shared = dicom.attributes().items(DicomTag.SHARED_GROUPS);
    DicomDataSet none = new DicomDataSet();
    DicomDataSet common = shared.isEmpty() ? none : shared.get(0);
    List<FrameAttributes> frames = new ArrayList<>(count);
    for (int n = 0; n < count; n++) {
      frames.add(new FrameAttributes(dicom, n < groups.size() ? groups.get(n) : none, common));
    }
    return frames;
  }

  /**
   * Returns the position of the frame, if it is known.
   *
   * @param single whether the file has one frame, whose position is that of the file
   */
  Optional<ImagePlane> plane(boolean single) throws VolumeFormatException {
    double[] position = decimals(DicomTag.PLANE_POSITION_SEQUENCE, DicomTag.POSITION, 3, single);
    double[] axes = decimals(DicomTag.PLANE_ORIENTATION_SEQUENCE, DicomTag.ORIENTATION, 6, true);
    if (position == null || axes == null) {
      return Optional.empty();
    }
    return Optional.of(plane(position, axes));
  }

  /** Returns a plane at a position with axes, and the pixel spacing of the frame. */
  ImagePlane plane(double[] position, double[] axes) throws VolumeFormatException {
    double[] spacing = decimals(DicomTag.PIXEL_MEASURES_SEQUENCE, DicomTag.PIXEL_SPACING, 2, true);
    if (spacing == null) {
      throw dicom.refusal(
          "the file has a position but no PixelSpacing, so the size of a pixel is unknown",
          "export the series again with its PixelSpacing");
    }
    ImagePlane plane =
        new ImagePlane(
            new Vec3(position[0], position[1], position[2]),
            new Vec3(axes[0], axes[1], axes[2]),
            new Vec3(axes[3], axes[4], axes[5]),
            spacing[1],
            spacing[0]);
    if (!plane.position().isFinite()
        || !(spacing[0] > 0 && spacing[1] > 0)
        || !plane.normal().isFinite()) {
      throw dicom.refusal(
          "the position, orientation or pixel spacing is invalid", "export the series again");
    }
    return plane;
  }

  /** Returns the map from stored numbers to values. */
  Scaling scaling() throws VolumeFormatException {
    double[] slope = decimals(DicomTag.VALUE_SEQUENCE, DicomTag.SLOPE, 1, true);
    double[] intercept = decimals(DicomTag.VALUE_SEQUENCE, DicomTag.INTERCEPT, 1, true);
    Scaling scaling =
        new Scaling(slope == null ? 1 : slope[0], intercept == null ? 0 : intercept[0]);
    if (!Double.isFinite(scaling.slope())
        || scaling.slope() == 0
        || !Double.isFinite(scaling.intercept())) {
      throw dicom.refusal("the rescale slope or intercept is invalid", "export the series again");
    }
    return scaling;
  }

  /** Returns exactly {@code count} decimals, or null if the attribute is absent. */
  double[] decimals(int sequence, int tag, int count, boolean alsoOfFile) {
    for (DicomDataSet item : items(sequence)) {
      double[] found = item.decimals(tag, count);
      if (found != null) {
        return found;
      }
    }
    return alsoOfFile ? dicom.attributes().decimals(tag, count) : null;
  }

  /** Returns a text, or a whole number as text; empty if the attribute is absent. */
  String text(int sequence, int tag) {
    List<DicomDataSet> sets = new ArrayList<>(items(sequence));
    sets.add(dicom.attributes());
    for (DicomDataSet set : sets) {
      int[] numbers = set.numbers(tag);
      String found = numbers.length > 0 ? Integer.toString(numbers[0]) : set.text(tag);
      if (!found.isEmpty()) {
        return found;
      }
    }
    return "";
  }

  /** Returns a number, or the fallback if the attribute is absent. */
  int number(int sequence, int tag, int fallback) {
    for (DicomDataSet item : items(sequence)) {
      if (item.numbers(tag).length > 0) {
        return item.number(tag, fallback);
      }
    }
    return fallback;
  }

  private List<DicomDataSet> items(int sequence) {
    List<DicomDataSet> items = new ArrayList<>(own.items(sequence));
    items.addAll(shared.items(sequence));
    return items;
  }
}
