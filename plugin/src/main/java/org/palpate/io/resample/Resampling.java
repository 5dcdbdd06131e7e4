package org.palpate.io.resample;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberParser;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.VoxelGrid;

/**
 * A new grid for a volume, and where its voxels lie in the old one.
 *
 * @param grid the new grid
 * @param toSource from the coordinates of the new grid to those of the old one
 */
public record Resampling(VoxelGrid grid, AffineMap toSource) {
  private static final double MOST_VOXELS = 1 << 30;

  /**
   * Returns a grid of the voxels in a box. The text {@code 10..99,0..63,5..40} is the first and the
   * last voxel along x, y and z.
   *
   * @throws VolumeFormatException if the text has another form, or the box leaves the grid
   */
  public static Resampling crop(VoxelGrid source, String box) throws VolumeFormatException {
    String[] ranges = box.split(",", -1);
    int[] sizes = {source.sizeX(), source.sizeY(), source.sizeZ()};
    int[] first = new int[3];
    int[] last = new int[3];
    boolean isRight = ranges.length == 3;
    for (int axis = 0; isRight && axis < 3; axis++) {
      String[] ends = ranges[axis].split("\\.\\.", -1);
      isRight = ends.length == 2 && ends[0].matches("[0-9]{1,9}") && ends[1].matches("[0-9]{1,9}");
      first[axis] = isRight ? Integer.parseInt(ends[0]) : 0;
      last[axis] = isRight ? Integer.parseInt(ends[1]) : 0;
      isRight = isRight && first[axis] <= last[axis] && last[axis] < sizes[axis];
    }
    if (!isRight) {
      throw new VolumeFormatException(
          "the box is not understood or leaves the volume of "
              + (sizes[0] + " x " + sizes[1] + " x " + sizes[2])
              + " voxels",
          "--crop " + box,
          "write first..last along x, y and z, for example 10..99,0..63,5..40");
    }
    AffineMap shift = new AffineMap();
    shift.offsetX = first[0];
    shift.offsetY = first[1];
    shift.offsetZ = first[2];
    RigidTransform axes = source.gridMmToWorld();
    Vec3 corner = source.gridToWorld(new Vec3(first[0], first[1], first[2]), new Vec3());
    return new Resampling(
        new VoxelGrid(
            last[0] - first[0] + 1,
            last[1] - first[1] + 1,
            last[2] - first[2] + 1,
            source.spacingMm(),
            new RigidTransform(axes.axisX(), axes.axisY(), axes.axisZ(), corner)),
        shift);
  }

  /**
   * Returns voxels of another size from the same corner, as in {@code 0.5}, {@code 0.5,0.5,1} (mm)
   * or {@code x2} (twice as many along each axis). Their number is rounded.
   *
   * @throws VolumeFormatException if the text has another form, or there would be too many voxels
   */
  public static Resampling spacing(VoxelGrid source, String text) throws VolumeFormatException {
    Vec3 old = source.spacingMm();
    double[] edges = numbers(text.startsWith("x") ? text.substring(1) : text);
    Vec3 spacing =
        text.startsWith("x")
            ? new Vec3(old.x / edges[0], old.y / edges[1], old.z / edges[2])
            : new Vec3(edges[0], edges[1], edges[2]);
    double x = Math.max(1, Math.rint(source.sizeX() * old.x / spacing.x));
    double y = Math.max(1, Math.rint(source.sizeY() * old.y / spacing.y));
    double z = Math.max(1, Math.rint(source.sizeZ() * old.z / spacing.z));
    boolean isValid = true;
    for (int axis = 0; axis < 3; axis++) {
      isValid = isValid && edges[axis] > 0 && GridMetric.isValidSpacing(spacing.get(axis));
    }
    if (!(isValid && x * y * z <= MOST_VOXELS)) {
      throw new VolumeFormatException(
          "the voxels are not understood, are too large or small, or are more than 2^30",
          "--resample " + text,
          "write their edges in mm, as 0.5 or 0.5,0.5,1, or a factor, as x2");
    }
    AffineMap scaling = new AffineMap();
    scaling.mXX = spacing.x / old.x;
    scaling.mYY = spacing.y / old.y;
    scaling.mZZ = spacing.z / old.z;
    return new Resampling(
        new VoxelGrid((int) x, (int) y, (int) z, spacing, source.gridMmToWorld()), scaling);
  }

  /** Returns three numbers, or one three times; NaN if there are others. */
  private static double[] numbers(String text) {
    String[] words = text.split(",", -1);
    double[] numbers = {Double.NaN, Double.NaN, Double.NaN};
    for (int n = 0; n < 3 && (words.length == 1 || words.length == 3); n++) {
      numbers[n] = NumberParser.number(words[words.length == 1 ? 0 : n]);
    }
    return numbers;
  }

  /**
   * Returns the same grid, on which the volume appears mirrored at a plane. The text {@code
   * 80,0,0,1,0,0} is a point of the plane and its normal, world mm.
   *
   * @throws VolumeFormatException if the text has another form
   */
  public static Resampling mirror(VoxelGrid source, String plane) throws VolumeFormatException {
    Plane mirror =
        Plane.parse(plane)
            .orElseThrow(
                () ->
                    new VolumeFormatException(
                        "the plane is not understood",
                        "--mirror " + plane,
                        "write a point and a normal in mm, X,Y,Z,NX,NY,NZ, for example"
                            + " 80,0,0,1,0,0"));
    AffineMap worldToGrid = source.worldToGrid(new AffineMap());
    AffineMap mirrored = worldToGrid.multiply(reflection(mirror), new AffineMap());
    return new Resampling(
        source, mirrored.multiply(source.gridToWorld(new AffineMap()), new AffineMap()));
  }

  private static AffineMap reflection(Plane mirror) {
    Vec3 n = mirror.normal();
    double offset = 2 * n.dot(mirror.pointMm());
    AffineMap m = new AffineMap();
    m.mXX = 1 - 2 * n.x * n.x;
    m.mXY = -2 * n.x * n.y;
    m.mXZ = -2 * n.x * n.z;
    m.mYX = -2 * n.y * n.x;
    m.mYY = 1 - 2 * n.y * n.y;
    m.mYZ = -2 * n.y * n.z;
    m.mZX = -2 * n.z * n.x;
    m.mZY = -2 * n.z * n.y;
    m.mZZ = 1 - 2 * n.z * n.z;
    m.offsetX = offset * n.x;
    m.offsetY = offset * n.y;
    m.offsetZ = offset * n.z;
    return m;
  }
}
