package org.palpate.edit;

import org.palpate.geometry.AffineMap;

/**
 * Makes every voxel solid or empty whose centre lies in the solid of the rigid tool. The solid
 * stands at the device pose of the frame in which the edit begins. Nothing happens without a rigid
 * tool. A large tool takes several frames.
 */
public final class ShapeEdit extends BoxEdit {
  /** The frame of a grid may differ from an orthonormal one by less than this factor. */
  private static final double DISTORTION = 1.01;

  private final Shape shape;
  private final double radiusMm;
  private final boolean solid;
  private final BrushLimits limits;
  private final AffineMap gridToDevice = new AffineMap();

  /** A solid in the tool frame. */
  @FunctionalInterface
  public interface Shape {
    /**
     * {@return whether the solid holds a point} Haptic thread.
     *
     * @param x the point along x, in the frame of the tool, mm
     * @param y its y component
     * @param z its z component
     */
    boolean contains(double x, double y, double z);
  }

  /**
   * Makes an edit.
   *
   * @param segment index of the segment in the scene
   * @param shape the solid
   * @param radiusMm the distance from the origin of the tool frame within which it lies, mm
   * @param solid whether the voxels become solid; otherwise they become empty
   * @param limits the voxels that it leaves as they are
   */
  public ShapeEdit(int segment, Shape shape, double radiusMm, boolean solid, BrushLimits limits) {
    super(segment);
    this.shape = shape;
    this.radiusMm = radiusMm;
    this.solid = solid;
    this.limits = limits;
  }

  @Override
  void findBox(VoxelWriter out) {
    if (out.tool().gridToDevice(segment(), gridToDevice)) {
      // The rows are orthogonal, so the transpose leads back; its scale is that of the spacing.
      double x = back(gridToDevice.mXX, gridToDevice.mYX, gridToDevice.mZX);
      double y = back(gridToDevice.mXY, gridToDevice.mYY, gridToDevice.mZY);
      double z = back(gridToDevice.mXZ, gridToDevice.mYZ, gridToDevice.mZZ);
      include(x, y, z, DISTORTION * radiusMm);
    }
  }

  /** Returns a grid coordinate of the tool's origin; the image of that axis is given. */
  private double back(double axisX, double axisY, double axisZ) {
    double along =
        gridToDevice.offsetX * axisX + gridToDevice.offsetY * axisY + gridToDevice.offsetZ * axisZ;
    return -along / (axisX * axisX + axisY * axisY + axisZ * axisZ);
  }

  @Override
  boolean visit(VoxelWriter out, int i, int j, int k) {
    double x = gridToDevice.x(i + 0.5, j + 0.5, k + 0.5);
    double y = gridToDevice.y(i + 0.5, j + 0.5, k + 0.5);
    double z = gridToDevice.z(i + 0.5, j + 0.5, k + 0.5);
    return shape.contains(x, y, z) && limits.write(out, segment(), i, j, k, solid);
  }
}
