package org.palpate.io.dicom;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.format.Scaling;
import org.palpate.io.volume.VolumeFormatException;

/**
 * One frame of a DICOM file.
 *
 * @param dicom the file
 * @param index the frame in the file, from 0
 * @param plane its position in the patient, if the file names it
 * @param scaling maps stored numbers to values
 */
record DicomFrame(DicomFile dicom, int index, Optional<ImagePlane> plane, Scaling scaling) {

  /**
   * The position of a frame in patient coordinates (LPS).
   *
   * @param position centre of the first pixel, mm
   * @param rowDirection direction along a row of pixels, a unit vector up to rounding
   * @param columnDirection direction along a column of pixels
   * @param columnSpacingMm distance between columns
   * @param rowSpacingMm distance between rows
   */
  record ImagePlane(
      Vec3 position,
      Vec3 rowDirection,
      Vec3 columnDirection,
      double columnSpacingMm,
      double rowSpacingMm) {

    /** Returns the unit normal of the frame. */
    Vec3 normal() {
      Vec3 cross =
          new Vec3(
              rowDirection.y * columnDirection.z - rowDirection.z * columnDirection.y,
              rowDirection.z * columnDirection.x - rowDirection.x * columnDirection.z,
              rowDirection.x * columnDirection.y - rowDirection.y * columnDirection.x);
      return cross.mul(1 / cross.length(), cross);
    }
  }

  /** Returns the frames of a file that passed {@link DicomFile#check}. */
  static List<DicomFrame> of(DicomFile dicom) throws VolumeFormatException {
    int count = dicom.frameCount();
    if (dicom.syntax().coding() == TransferSyntax.Coding.PLAIN
        ? count > dicom.pixelDataItems().get(0).length()
        : count > dicom.pixelDataItems().size()) {
      throw dicom.refusal(
          "the header promises " + count + " frames, more than the file can have",
          "export the file again");
    }
    DicomFrame[] frames = new DicomFrame[count];
    List<DicomDataSet> groups = dicom.attributes().items(DicomTag.FRAME_GROUPS);
    List<DicomDataSet> shared = dicom.attributes().items(DicomTag.SHARED_GROUPS);
    for (int n = 0; n < count; n++) {
      DicomDataSet own = n < groups.size() ? groups.get(n) : new DicomDataSet();
      DicomDataSet common = shared.isEmpty() ? new DicomDataSet() : shared.get(0);
      Lookup lookup = new Lookup(dicom, own, common);
      // the position of the file is that of a frame only if there is one
      frames[n] = new DicomFrame(dicom, n, lookup.plane(count == 1), lookup.scaling());
    }
    return List.of(frames);
  }

  /**
   * Looks up the attributes of a frame: first its own, then the shared ones, then those of the
   * file.
   */
  private record Lookup(DicomFile dicom, DicomDataSet own, DicomDataSet shared) {

    Optional<ImagePlane> plane(boolean single) throws VolumeFormatException {
      double[] position = decimals(DicomTag.PLANE_POSITION_SEQUENCE, DicomTag.POSITION, 3, single);
      double[] axes = decimals(DicomTag.PLANE_ORIENTATION_SEQUENCE, DicomTag.ORIENTATION, 6, true);
      double[] spacing =
          decimals(DicomTag.PIXEL_MEASURES_SEQUENCE, DicomTag.PIXEL_SPACING, 2, true);
      if (position == null || axes == null || spacing == null) {
        return Optional.empty();
      }
      Vec3 rowDirection = new Vec3(axes[0], axes[1], axes[2]);
      Vec3 columnDirection = new Vec3(axes[3], axes[4], axes[5]);
      ImagePlane plane =
          new ImagePlane(
              new Vec3(position[0], position[1], position[2]),
              rowDirection,
              columnDirection,
              spacing[1],
              spacing[0]);
      if (!plane.position().isFinite()
          || !(spacing[0] > 0 && spacing[1] > 0)
          || !plane.normal().isFinite()) {
        throw dicom.refusal(
            "the position, orientation or pixel spacing is invalid", "export the series again");
      }
      return Optional.of(plane);
    }

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

    private double[] decimals(int sequence, int tag, int count, boolean alsoOfFile) {
      for (DicomDataSet group : List.of(own, shared)) {
        for (DicomDataSet item : group.items(sequence)) {
          double[] found = item.decimals(tag, count);
          if (found != null) {
            return found;
          }
        }
      }
      return alsoOfFile ? dicom.attributes().decimals(tag, count) : null;
    }
  }
}
