package org.palpate.io.nifti;

import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.Grids;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The position of a NIfTI's voxels: from its affine matrix (sform), else from its quaternion
 * (qform), else along the stored axes with voxel 0 at the origin.
 *
 * <p>Source: nifti1.h, "3D image (volume) orientation and location in space".
 *
 * @param stepsMm steps to the next voxel along each axis
 * @param firstCentreMm the centre of voxel 0
 * @param isKnown whether the axes are those of the patient, RAS
 */
record NiftiAffine(List<Vec3> stepsMm, Vec3 firstCentreMm, boolean isKnown) {
  /** The largest excess of the squared quaternion over 1 that single precision can cause. */
  private static final double QUATERNION_TOLERANCE = 3 * 0x1p-23;

  /** The part of a voxel by which two positions may differ through single precision. */
  private static final double POSITION_TOLERANCE_VOXELS = 0.01;

  /** Returns the position that a header gives, and notes if it gives none, or two. */
  static NiftiAffine of(NiftiHeader header, List<String> notes) throws VolumeFormatException {
    double mm = mmPerUnit(header);
    if (header.sformCode() > 0) {
      NiftiAffine sform = bySform(header).scaled(mm);
      if (header.qformCode() > 0) {
        noteDisagreement(header, sform, mm, notes);
      }
      return sform;
    }
    noteNegativeSpacing(header, notes);
    if (header.qformCode() > 0) {
      return byQform(header).scaled(mm);
    }
    notes.add("the orientation in the patient is unknown: axes as stored");
    Vec3[] steps =
        Grids.steps(
            new Vec3(
                Math.abs(header.pixdim(1)),
                Math.abs(header.pixdim(2)),
                header.dim(0) < 3 ? 1 : Math.abs(header.pixdim(3))));
    return new NiftiAffine(List.of(steps), new Vec3(), false).scaled(mm);
  }

  /** Notes a quaternion that places a corner of the volume elsewhere than the matrix does. */
  private static void noteDisagreement(
      NiftiHeader header, NiftiAffine sform, double mm, List<String> notes) {
    double apart;
    try {
      apart = sform.largestDistance(byQform(header).scaled(mm), header);
    } catch (VolumeFormatException e) {
      notes.add("the quaternion (qform) is no rotation: the matrix (sform) is used");
      return;
    }
    double voxel =
        Math.min(
            sform.stepsMm.get(0).length(),
            Math.min(sform.stepsMm.get(1).length(), sform.stepsMm.get(2).length()));
    if (!(apart <= POSITION_TOLERANCE_VOXELS * voxel)) {
      notes.add(
          "the file states two positions that differ by up to "
              + NumberText.thousandths(apart)
              + " mm: its matrix (sform) is used, not its quaternion (qform)");
    }
  }

  /** Returns the largest distance between the corners of the volume in two positions, mm. */
  private double largestDistance(NiftiAffine other, NiftiHeader header) {
    double largest = 0;
    for (int corner = 0; corner < 8; corner++) {
      Vec3 apart = firstCentreMm.sub(other.firstCentreMm, new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        double voxels =
            header.dim(0) > axis ? (corner >> axis & 1) * (header.dim(axis + 1) - 1) : 0;
        Vec3 step = stepsMm.get(axis).sub(other.stepsMm.get(axis), new Vec3());
        apart.add(step.mul(voxels, step), apart);
      }
      largest = Math.max(largest, apart.length());
    }
    return largest;
  }

  private static void noteNegativeSpacing(NiftiHeader header, List<String> notes) {
    String understood = header.qformCode() > 0 ? Grids.RUNS_BACKWARD : "its size is used";
    for (int axis = 0; axis < Math.min(3, header.dim(0)); axis++) {
      if (header.pixdim(axis + 1) < 0) {
        notes.add(Grids.negativeSpacing(axis, header.pixdim(axis + 1), understood));
      }
    }
  }

  private NiftiAffine scaled(double mm) {
    for (Vec3 step : stepsMm) {
      step.mul(mm, step);
    }
    firstCentreMm.mul(mm, firstCentreMm);
    return this;
  }

  private static double mmPerUnit(NiftiHeader header) {
    return switch (header.lengthUnit()) {
      case 1 -> 1000;
      case 3 -> 1e-3;
      default -> 1;
    };
  }

  private static NiftiAffine bySform(NiftiHeader header) {
    Vec3[] columns = new Vec3[4];
    for (int column = 0; column < 4; column++) {
      columns[column] =
          new Vec3(header.srow(0, column), header.srow(1, column), header.srow(2, column));
    }
    return new NiftiAffine(List.of(columns[0], columns[1], columns[2]), columns[3], true);
  }

  private static NiftiAffine byQform(NiftiHeader header) throws VolumeFormatException {
    double b = header.quatern(0);
    double c = header.quatern(1);
    double d = header.quatern(2);
    double rest = 1 - (b * b + c * c + d * d);
    if (!(rest >= -QUATERNION_TOLERANCE)) {
      throw header.refusal("the quaternion (" + b + ", " + c + ", " + d + ") is no rotation");
    }
    double a = rest < QUATERNION_TOLERANCE ? 0 : Math.sqrt(rest);
    double s = 2 / (a * a + b * b + c * c + d * d);
    Vec3 x = new Vec3(1 - s * (c * c + d * d), s * (b * c + a * d), s * (b * d - a * c));
    Vec3 y = new Vec3(s * (b * c - a * d), 1 - s * (b * b + d * d), s * (c * d + a * b));
    Vec3 z = new Vec3(s * (b * d + a * c), s * (c * d - a * b), 1 - s * (b * b + c * c));
    double handedness = header.pixdim(0) < 0 ? -1 : 1;
    Vec3[] steps = {
      x.mul(header.pixdim(1), x),
      y.mul(header.pixdim(2), y),
      z.mul(header.pixdim(3) * handedness, z)
    };
    Vec3 centre = new Vec3(header.quatern(3), header.quatern(4), header.quatern(5));
    return new NiftiAffine(List.of(steps), centre, true);
  }
}
