package org.palpate.volume;

import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * How many voxels there are, how large they are and where they lie. Immutable.
 *
 * <p>Three frames: <em>grid</em> (voxel (i,j,k) is the cell from (i,j,k) to (i+1,j+1,k+1)),
 * <em>grid millimetres</em> (grid times spacing, axes along the grid's) and <em>world</em>
 * (millimetres, as the file says).
 *
 * @param sizeX voxels along x, at least 1
 * @param sizeY voxels along y, at least 1
 * @param sizeZ voxels along z, at least 1
 * @param spacingMm edge lengths of a voxel, from {@link GridMetric#MIN_SPACING_MM} to {@link
 *     GridMetric#MAX_SPACING_MM}
 * @param gridMmToWorld from grid millimetres to world; its origin is the world position of the
 *     corner (0,0,0) of voxel 0
 */
public record VoxelGrid(
    int sizeX, int sizeY, int sizeZ, Vec3 spacingMm, RigidTransform gridMmToWorld) {

  /** Checks sizes and spacing. */
  public VoxelGrid {
    if (sizeX < 1 || sizeY < 1 || sizeZ < 1) {
      throw new IllegalArgumentException(
          "sizes must be at least 1: sizes=" + sizeX + "x" + sizeY + "x" + sizeZ);
    }
    if (!GridMetric.isValidSpacing(spacingMm.x)
        || !GridMetric.isValidSpacing(spacingMm.y)
        || !GridMetric.isValidSpacing(spacingMm.z)) {
      throw new IllegalArgumentException(
          "spacing must be from 1e-12 to 1e12 mm: spacingMm=" + spacingMm);
    }
  }

  /** A grid of unit voxels whose grid coordinates are its world coordinates. */
  public static VoxelGrid ofUnitVoxels(int sizeX, int sizeY, int sizeZ) {
    return new VoxelGrid(sizeX, sizeY, sizeZ, new Vec3(1, 1, 1), RigidTransform.identity());
  }

  /**
   * A grid as files describe it: by the world position of the <em>centre</em> of voxel 0 and the
   * directions of its axes.
   *
   * @param axes orthonormal directions; its origin is the centre of voxel (0,0,0), world mm
   */
  public static VoxelGrid ofFirstCentre(
      int sizeX, int sizeY, int sizeZ, Vec3 spacingMm, RigidTransform axes) {
    Vec3 halfVoxel = new Vec3(-spacingMm.x / 2, -spacingMm.y / 2, -spacingMm.z / 2);
    Vec3 corner = axes.transform(halfVoxel, new Vec3());
    return new VoxelGrid(
        sizeX,
        sizeY,
        sizeZ,
        spacingMm,
        new RigidTransform(axes.axisX(), axes.axisY(), axes.axisZ(), corner));
  }

  /** The number of voxels. */
  public long voxelCount() {
    return (long) sizeX * sizeY * sizeZ;
  }

  public boolean contains(int i, int j, int k) {
    return i >= 0 && i < sizeX && j >= 0 && j < sizeY && k >= 0 && k < sizeZ;
  }

  /**
   * Writes the world position, mm, of a point in grid coordinates into {@code dest}, which may be
   * the point.
   */
  public Vec3 gridToWorld(Vec3 grid, Vec3 dest) {
    dest.set(grid.x * spacingMm.x, grid.y * spacingMm.y, grid.z * spacingMm.z);
    return gridMmToWorld.transform(dest, dest);
  }

  /**
   * Writes the grid coordinates of a world position, mm, into {@code dest}, which may be the
   * position.
   */
  public Vec3 worldToGrid(Vec3 world, Vec3 dest) {
    gridMmToWorld.inverseTransform(world, dest);
    return dest.set(dest.x / spacingMm.x, dest.y / spacingMm.y, dest.z / spacingMm.z);
  }
}
