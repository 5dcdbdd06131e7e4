package org.palpate.imagej.stack;

import ij.ImagePlus;
import ij.measure.Calibration;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.tiff.ImagejUnit;
import org.palpate.volume.VoxelGrid;

/**
 * The position and size of a stack's voxels by its calibration. Voxel edges are in millimetres
 * whatever the unit; the world is ImageJ's calibrated coordinates in millimetres.
 *
 * <p>ImageJ counts from the corner of a pixel and from its origin; slice s, counted from 1, spans
 * s-1 to s in z.
 *
 * @param grid sizes, spacing in mm and position
 * @param unit the stack's unit of length, as ImageJ names it
 * @param mmPerUnit the length of one unit in mm; 1 if the unit is not a length
 */
public record StackGeometry(VoxelGrid grid, String unit, double mmPerUnit) {
  /**
   * Reads a stack's calibration.
   *
   * @throws TouchRefusedException if a voxel edge is not positive and finite
   */
  public static StackGeometry of(ImagePlus image) throws TouchRefusedException {
    Calibration calibration = image.getCalibration();
    String unit = calibration.getUnit();
    double stated = ImagejUnit.mm(unit);
    double mmPerUnit = Double.isNaN(stated) ? 1 : stated;
    Vec3 spacingMm =
        new Vec3(
            Math.abs(calibration.pixelWidth) * mmPerUnit,
            Math.abs(calibration.pixelHeight) * mmPerUnit,
            Math.abs(calibration.pixelDepth) * mmPerUnit);
    if (!(spacingMm.x > 0 && spacingMm.y > 0 && spacingMm.z > 0) || !spacingMm.isFinite()) {
      throw new TouchRefusedException(
          "The voxel size is not positive: set it by Image > Properties... (Ctrl+Shift+P).");
    }
    Vec3 corner =
        new Vec3(
            -calibration.xOrigin * spacingMm.x,
            -calibration.yOrigin * spacingMm.y,
            -calibration.zOrigin * spacingMm.z);
    RigidTransform axes =
        new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), corner);
    VoxelGrid grid =
        new VoxelGrid(
            image.getWidth(), image.getHeight(), Math.max(1, image.getNSlices()), spacingMm, axes);
    return new StackGeometry(grid, unit, mmPerUnit);
  }

  /**
   * Writes a point in ImageJ's calibrated units into {@code dest} and returns it.
   *
   * @param point grid coordinates
   */
  public Vec3 gridToCalibrated(Vec3 point, Vec3 dest) {
    return grid.gridToWorld(point, dest).mul(1 / mmPerUnit, dest);
  }
}
