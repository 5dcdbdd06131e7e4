package org.palpate.volume;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A voxel grid: the number of voxels, their size, and their position in the world. Immutable; any
 * thread.
 *
 * <p>There are three frames. In <em>grid</em> coordinates voxel (i,j,k) is the cell from (i,j,k) to
 * (i+1,j+1,k+1). <em>Grid millimetres</em> are grid coordinates times the spacing. <em>World</em>
 * coordinates are the millimetres of the file.
 *
 * @param sizeX the number of voxels along x, at least 1
 * @param sizeY the number of voxels along y, at least 1
 * @param sizeZ the number of voxels along z, at least 1
 * @param spacingMm the edges of a voxel, from {@link GridMetric#MIN_SPACING_MM} to {@link
 *     GridMetric#MAX_SPACING_MM}
 * @param gridMmToWorld the transform from grid millimetres to world; its origin is the world
 *     position of the corner (0,0,0) of voxel (0,0,0)
 */
public record VoxelGrid(
    int sizeX, int sizeY, int sizeZ, Vec3 spacingMm, RigidTransform gridMmToWorld) {

  /**
   * Checks sizes and spacing.
   *
   * @throws IllegalArgumentException if a size is below 1 or a spacing is not valid
   */
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

  /**
   * {@return a grid of voxels of 1 mm whose grid coordinates equal its world coordinates}
   *
   * @param sizeX the number of voxels along x, at least 1
   * @param sizeY the number of voxels along y, at least 1
   * @param sizeZ the number of voxels along z, at least 1
   */
  public static VoxelGrid ofUnitVoxels(int sizeX, int sizeY, int sizeZ) {
    return new VoxelGrid(sizeX, sizeY, sizeZ, new Vec3(1, 1, 1), RigidTransform.identity());
  }

  /**
   * {@return a grid from the description that files use: the world position of the <em>centre</em>
   * of voxel (0,0,0) and the directions of the axes}
   *
   * @param sizeX the number of voxels along x, at least 1
   * @param sizeY the number of voxels along y, at least 1
   * @param sizeZ the number of voxels along z, at least 1
   * @param spacingMm the edges of a voxel along the axes, mm; kept
   * @param axes the directions, orthonormal; its origin is the centre of voxel (0,0,0), world mm
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

  /** {@return the metric of the grid} */
  public GridMetric metric() {
    return GridMetric.of(spacingMm);
  }

  /** {@return the number of voxels} */
  public long voxelCount() {
    return (long) sizeX * sizeY * sizeZ;
  }

  /**
   * {@return whether voxel (i,j,k) lies in the grid}
   *
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   */
  public boolean contains(int i, int j, int k) {
    return i >= 0 && i < sizeX && j >= 0 && j < sizeY && k >= 0 && k < sizeZ;
  }

  /**
   * {@return the length of the diagonal of a box of voxels that is not empty, mm}
   *
   * @param box the box, in voxels, not empty
   */
  public double diagonalMm(IntBox box) {
    return new Vec3(
            (box.highX - box.lowX + 1) * spacingMm.x,
            (box.highY - box.lowY + 1) * spacingMm.y,
            (box.highZ - box.lowZ + 1) * spacingMm.z)
        .length();
  }

  /**
   * Writes the world position of a point.
   *
   * @param grid the point, grid coordinates
   * @param dest receives the position, world mm; may be {@code grid}
   * @return {@code dest}
   */
  public Vec3 gridToWorld(Vec3 grid, Vec3 dest) {
    dest.set(grid.x * spacingMm.x, grid.y * spacingMm.y, grid.z * spacingMm.z);
    return gridMmToWorld.transform(dest, dest);
  }

  /**
   * Writes the grid coordinates of a point.
   *
   * @param world the point, world mm
   * @param dest receives the grid coordinates; may be {@code world}
   * @return {@code dest}
   */
  public Vec3 worldToGrid(Vec3 world, Vec3 dest) {
    gridMmToWorld.inverseTransform(world, dest);
    return dest.set(dest.x / spacingMm.x, dest.y / spacingMm.y, dest.z / spacingMm.z);
  }

  /**
   * Writes the map from grid coordinates to world mm.
   *
   * @param dest receives the map
   * @return {@code dest}
   */
  public AffineMap gridToWorld(AffineMap dest) {
    AffineMap scaling = new AffineMap();
    scaling.mXX = spacingMm.x;
    scaling.mYY = spacingMm.y;
    scaling.mZZ = spacingMm.z;
    return new AffineMap().set(gridMmToWorld).multiply(scaling, dest);
  }

  /**
   * Writes the map from world mm to grid coordinates.
   *
   * @param dest receives the map
   * @return {@code dest}
   */
  public AffineMap worldToGrid(AffineMap dest) {
    return dest.setInverseGrid(gridMmToWorld, spacingMm);
  }
}
