package org.palpate.io.nifti;

import java.util.List;
import org.palpate.geometry.Vec3;
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

  /** Returns the position that a header gives, and notes if it gives none. */
  static NiftiAffine of(NiftiHeader header, List<String> notes) throws VolumeFormatException {
    double mm = mmPerUnit(header);
    if (header.sformCode() > 0) {
      return bySform(header).scaled(mm);
    }
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
