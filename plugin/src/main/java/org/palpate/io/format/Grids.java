package org.palpate.io.format;

import java.nio.file.Path;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.VoxelGrid;

/** Creates voxel grids from header values, or refuses them with the numbers. */
public final class Grids {
  /** More bricks of 64 voxels than any bit cube can have. */
  private static final double MAX_BRICKS = Integer.MAX_VALUE - 8;

  /** The meaning of a negative spacing in most formats. */
  public static final String RUNS_BACKWARD = "that axis runs backward";

  private Grids() {}

  /**
   * Returns the grid of a header.
   *
   * @param sizes three sizes of at least 1
   * @param stepsMm the three steps to the next voxel, orthogonal vectors in the world
   * @param firstCentre the world position of the centre of voxel 0, mm
   */
  public static VoxelGrid of(int[] sizes, Vec3[] stepsMm, Vec3 firstCentre, Path file)
      throws VolumeFormatException {
    requireSizes(sizes, file);
    Vec3 spacing = new Vec3();
    Vec3[] axes = new Vec3[3];
    for (int axis = 0; axis < 3; axis++) {
      double length = stepsMm[axis].length();
      if (!GridMetric.isValidSpacing(length)) {
        throw new VolumeFormatException(
            "the spacing along axis " + "xyz".charAt(axis) + " is " + length + " mm",
            file,
            "give the file spacings from 1e-12 to 1e12 mm in the tool that wrote it");
      }
      spacing.set(axis, length);
      axes[axis] = stepsMm[axis].mul(1 / length, new Vec3());
    }
    if (!firstCentre.isFinite()) {
      throw new VolumeFormatException(
          "the origin " + firstCentre + " is not finite",
          file,
          "export the file again with an origin");
    }
    RigidTransform place = new RigidTransform(axes[0], axes[1], axes[2], firstCentre);
    if (!place.isOrthonormal()) {
      throw new VolumeFormatException(
          "the axes are not at right angles (" + angles(axes) + " degrees)",
          file,
          "resample it onto a rectangular grid in the tool that wrote it");
    }
    return VoxelGrid.ofFirstCentre(sizes[0], sizes[1], sizes[2], spacing, place);
  }

  /** Returns a grid along the world axes with the centre of its first voxel at the origin. */
  public static VoxelGrid ofSpacing(int[] sizes, Vec3 spacingMm, Path file)
      throws VolumeFormatException {
    return of(sizes, steps(spacingMm), new Vec3(), file);
  }

  /** Returns the three steps to the next voxel along the world axes. */
  public static Vec3[] steps(Vec3 spacingMm) {
    return new Vec3[] {
      new Vec3(spacingMm.x, 0, 0), new Vec3(0, spacingMm.y, 0), new Vec3(0, 0, spacingMm.z)
    };
  }

  /** Returns the step from a voxel to the next along an axis of the grid, in world millimetres. */
  public static Vec3 stepMm(VoxelGrid grid, int axis) {
    Vec3 step = new Vec3();
    step.set(axis, grid.spacingMm().get(axis));
    return grid.gridMmToWorld().rotate(step, step);
  }

  /**
   * Returns the note on a spacing that a header states as negative.
   *
   * @param understood how the file is understood: {@link #RUNS_BACKWARD} or other words
   */
  public static String negativeSpacing(int axis, double spacing, String understood) {
    return "the spacing along "
        + "xyz".charAt(axis)
        + " is stated as "
        + NumberText.display(spacing)
        + ": "
        + understood;
  }

  private static void requireSizes(int[] sizes, Path file) throws VolumeFormatException {
    String text = sizes[0] + "x" + sizes[1] + "x" + sizes[2];
    if (sizes[0] < 1 || sizes[1] < 1 || sizes[2] < 1) {
      throw new VolumeFormatException(
          "the size is " + text + " voxels", file, "write a volume with at least one voxel");
    }
    double bricks =
        Math.ceil(sizes[0] / 4.0) * Math.ceil(sizes[1] / 4.0) * Math.ceil(sizes[2] / 4.0);
    if (bricks > MAX_BRICKS || (double) sizes[0] * sizes[1] > MAX_BRICKS) {
      throw new VolumeFormatException(
          "the size is " + text + " voxels, more than fit in any memory",
          file,
          "crop or halve the volume in the tool that wrote it");
    }
  }

  private static String angles(Vec3[] axes) {
    return angle(axes[0], axes[1])
        + ", "
        + angle(axes[1], axes[2])
        + ", "
        + angle(axes[2], axes[0]);
  }

  private static double angle(Vec3 a, Vec3 b) {
    double cosine = a.dot(b) / (a.length() * b.length());
    double degrees = StrictMath.toDegrees(StrictMath.acos(Math.max(-1, Math.min(1, cosine))));
    return Math.rint(degrees * 1000) / 1000;
  }
}
