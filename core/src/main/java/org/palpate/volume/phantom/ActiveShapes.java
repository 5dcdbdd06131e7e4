package org.palpate.volume.phantom;

/**
 * Sorts the shapes of a phantom by a ball. The surface of an active shape may pass through the
 * ball; any other shape contains the whole ball or none of it. The ball is narrowed from rows to
 * bricks to voxels, so that a voxel evaluates the few active shapes alone. Owned scratch.
 */
final class ActiveShapes {
  /** More than the rounding of a shape's value; all sizes are below 1e4 voxels. */
  private static final double ROUNDING_VOXELS = 1e-6;

  private final Shape[] shapes;
  private final int[] active;
  private int activeCount;
  private long insideInactive;

  ActiveShapes(Shape[] shapes) {
    this.shapes = shapes;
    active = new int[shapes.length];
  }

  /** Resets this to the whole space, in which every shape is active. */
  void widen() {
    activeCount = shapes.length;
    insideInactive = 0;
    for (int s = 0; s < shapes.length; s++) {
      active[s] = s;
    }
  }

  /** Narrows {@code parent}, which must be another, to a ball of {@code radius} at the point. */
  void narrow(ActiveShapes parent, double x, double y, double z, double radius) {
    activeCount = 0;
    insideInactive = parent.insideInactive;
    double limit = radius + ROUNDING_VOXELS;
    for (int n = 0; n < parent.activeCount; n++) {
      int shape = parent.active[n];
      double value = shapes[shape].at(x, y, z);
      if (Math.abs(value) <= limit) {
        active[activeCount++] = shape;
      } else if (value <= 0) {
        insideInactive |= 1L << shape;
      }
    }
  }

  /** Whether no surface passes through the ball. */
  boolean isUniform() {
    return activeCount == 0;
  }

  /** Returns a bit for each shape that contains the point, which must lie within the ball. */
  long insideShapes(double x, double y, double z) {
    long inside = insideInactive;
    for (int n = 0; n < activeCount; n++) {
      int shape = active[n];
      if (shapes[shape].at(x, y, z) <= 0) {
        inside |= 1L << shape;
      }
    }
    return inside;
  }

  /**
   * Returns the number of sign patterns: the sides of the active surfaces that a point can have.
   */
  long signPatternCount() {
    return 1L << activeCount;
  }

  /** Returns the sign pattern of a point, below {@link #signPatternCount}. */
  int signPattern(double x, double y, double z) {
    int pattern = 0;
    for (int n = 0; n < activeCount; n++) {
      pattern |= (shapes[active[n]].at(x, y, z) <= 0 ? 1 : 0) << n;
    }
    return pattern;
  }

  /** Returns a bit for each shape that contains the points of a sign pattern. */
  long insideShapesAt(int pattern) {
    long inside = insideInactive;
    for (int n = 0; n < activeCount; n++) {
      inside |= (pattern >> n & 1L) << active[n];
    }
    return inside;
  }
}
