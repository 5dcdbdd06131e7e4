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
 * @param attributes the attributes of the frame
 */
record DicomFrame(
    DicomFile dicom,
    int index,
    Optional<ImagePlane> plane,
    Scaling scaling,
    FrameAttributes attributes) {

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

    /** The fraction by which spacings may differ and still count as equal. */
    static final double UNEVEN = 0.01;

    /** The rounding of positions that are written with a few decimals. */
    static final double POSITION_ROUNDING_MM = 2e-3;

    /** Planes that are nearer to each other along their normal have the same position. */
    static final double SAME_POSITION_MM = 1e-3;

    /** Unit vectors that are nearer to each other have the same direction. */
    static final double SAME_DIRECTION = 1e-4;

    /** Whether another plane has the same directions, within a tolerance, and pixel spacing. */
    boolean isParallelTo(ImagePlane other) {
      return Math.abs(columnSpacingMm - other.columnSpacingMm) <= UNEVEN * other.columnSpacingMm
          && Math.abs(rowSpacingMm - other.rowSpacingMm) <= UNEVEN * other.rowSpacingMm
          && directionDifference(other) <= SAME_DIRECTION;
    }

    /** Returns the larger distance between the unit vectors of two planes. */
    double directionDifference(ImagePlane other) {
      return Math.max(
          rowDirection.sub(other.rowDirection, new Vec3()).length(),
          columnDirection.sub(other.columnDirection, new Vec3()).length());
    }

    /** Returns the steps to the next voxel: along a row, along a column, and to the next plane. */
    Vec3[] steps(Vec3 toNextMm) {
      return new Vec3[] {
        rowDirection.mul(columnSpacingMm, new Vec3()),
        columnDirection.mul(rowSpacingMm, new Vec3()),
        toNextMm
      };
    }

    /** Returns this plane at another position. */
    ImagePlane at(Vec3 other) {
      return new ImagePlane(other, rowDirection, columnDirection, columnSpacingMm, rowSpacingMm);
    }

    /** Returns the unit normal of the frame. */
    Vec3 normal() {
      Vec3 cross = rowDirection.cross(columnDirection, new Vec3());
      return cross.mul(1 / cross.length(), cross);
    }
  }

  /** Returns the frames of a file that passed {@link DicomImageChecks#check}. */
  static List<DicomFrame> of(DicomFile dicom) throws VolumeFormatException {
    int count = dicom.frameCount();
    if (dicom.syntax().coding() == TransferSyntax.Coding.PLAIN
        ? count > dicom.pixelDataItems().get(0).length()
        : count > dicom.pixelDataItems().size()) {
      throw dicom.refusal(
          "the header promises " + count + " frames, more than the file can have",
          "export the file again");
    }
    if (DicomDose.isDose(dicom)) {
      return DicomDose.frames(dicom, count);
    }
    DicomFrame[] frames = new DicomFrame[count];
    List<FrameAttributes> attributes = FrameAttributes.of(dicom, count);
    for (int n = 0; n < count; n++) {
      FrameAttributes own = attributes.get(n);
      // the position of the file is that of a frame only if there is one
      frames[n] = new DicomFrame(dicom, n, own.plane(count == 1), own.scaling(), own);
    }
    return List.of(frames);
  }
}
