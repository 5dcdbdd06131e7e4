package org.palpate.volume.phantom;

/**
 * Which shapes can change within a ball, and on which side of the others the ball lies. Narrowed
 * from blocks to bricks to voxels, so that most shapes are never looked at. Owned scratch.
 */
final class Locality {
  /** How much farther than its ball a locality reaches: walls look at points one voxel off. */
  private static final double REACH_VOXELS = 1.0;

  /** More than all rounding in a shape's value, whose sizes stay under 1e4 voxels. */
  private static final double ROUNDING_VOXELS = 1e-6;

  private final Shape[] shapes;
  private final int[] changing;
  private int changingCount;
  private long insideFixed;
  private double nearest;

  Locality(Shape[] shapes) {
    this.shapes = shapes;
    changing = new int[shapes.length];
  }

  /** Everything may change: the whole space. */
  void widen() {
    changingCount = shapes.length;
    insideFixed = 0;
    for (int s = 0; s < shapes.length; s++) {
      changing[s] = s;
    }
  }

  /** Becomes the part of {@code parent} within {@code radius} of the point; may not be itself. */
  void narrow(Locality parent, double x, double y, double z, double radius) {
    changingCount = 0;
    insideFixed = parent.insideFixed;
    nearest = Double.POSITIVE_INFINITY;
    double limit = radius + REACH_VOXELS + ROUNDING_VOXELS;
    for (int n = 0; n < parent.changingCount; n++) {
      int shape = parent.changing[n];
      double value = shapes[shape].at(x, y, z);
      nearest = Math.min(nearest, Math.abs(value));
      if (Math.abs(value) <= limit) {
        changing[changingCount++] = shape;
      } else if (value <= 0) {
        insideFixed |= 1L << shape;
      }
    }
  }

  /** Whether no shape's surface comes within the ball and one voxel more. */
  boolean isUniform() {
    return changingCount == 0;
  }

  /**
   * Whether no shape's surface comes within {@code radius} of the point that it was narrowed to.
   */
  boolean isClear(double radius) {
    return nearest > radius + ROUNDING_VOXELS;
  }

  /** A bit for each shape that the point, which must lie within reach, is inside of. */
  long insideShapes(double x, double y, double z) {
    long inside = insideFixed;
    for (int n = 0; n < changingCount; n++) {
      int shape = changing[n];
      if (shapes[shape].at(x, y, z) <= 0) {
        inside |= 1L << shape;
      }
    }
    return inside;
  }
}
