package org.palpate.volume.phantom;

/**
 * Which shapes can change within a ball, and on which side of the others the ball lies. Narrowed
 * from blocks to bricks to voxels, so that most shapes are never looked at. Owned scratch.
 */
final class ActiveShapes {
  /** More than all rounding in a shape's value, whose sizes stay under 1e4 voxels. */
  private static final double ROUNDING_VOXELS = 1e-6;

  private final Shape[] shapes;
  private final int[] changing;
  private int changingCount;
  private long insideInactive;

  ActiveShapes(Shape[] shapes) {
    this.shapes = shapes;
    changing = new int[shapes.length];
  }

  /** Everything may change: the whole space. */
  void widen() {
    changingCount = shapes.length;
    insideInactive = 0;
    for (int s = 0; s < shapes.length; s++) {
      changing[s] = s;
    }
  }

  /** Becomes the part of {@code parent} within {@code radius} of the point; may not be itself. */
  void narrow(ActiveShapes parent, double x, double y, double z, double radius) {
    changingCount = 0;
    insideInactive = parent.insideInactive;
    double limit = radius + ROUNDING_VOXELS;
    for (int n = 0; n < parent.changingCount; n++) {
      int shape = parent.changing[n];
      double value = shapes[shape].at(x, y, z);
      if (Math.abs(value) <= limit) {
        changing[changingCount++] = shape;
      } else if (value <= 0) {
        insideInactive |= 1L << shape;
      }
    }
  }

  /** Whether no shape's surface comes within the ball. */
  boolean isUniform() {
    return changingCount == 0;
  }

  /** A bit for each shape that the point, which must lie within the ball, is inside of. */
  long insideShapes(double x, double y, double z) {
    long inside = insideInactive;
    for (int n = 0; n < changingCount; n++) {
      int shape = changing[n];
      if (shapes[shape].at(x, y, z) <= 0) {
        inside |= 1L << shape;
      }
    }
    return inside;
  }

  /** In how many ways a point within the ball may lie to the surfaces there, at most. */
  long sides() {
    return 1L << changingCount;
  }

  /** On which of the {@link #sides} the point lies. */
  int side(double x, double y, double z) {
    int side = 0;
    for (int n = 0; n < changingCount; n++) {
      side |= (shapes[changing[n]].at(x, y, z) <= 0 ? 1 : 0) << n;
    }
    return side;
  }

  /** A bit for each shape that a point on this side is inside of. */
  long insideShapesAt(int side) {
    long inside = insideInactive;
    for (int n = 0; n < changingCount; n++) {
      inside |= (side >> n & 1L) << changing[n];
    }
    return inside;
  }
}
