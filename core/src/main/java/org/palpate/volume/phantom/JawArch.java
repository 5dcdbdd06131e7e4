package org.palpate.volume.phantom;

import org.palpate.volume.BitCube;

/**
 * The bone of {@link FracturePhantom}: half a ring with rising ends, like a lower jaw. A wall of
 * compact bone encloses marrow, which counts as empty, and trabeculae cross it.
 */
final class JawArch {
  /** The edge of the cube for which the sizes below are millimetres. */
  private static final double NOMINAL_EDGE = 160;

  private static final double CENTRE_X = 80;
  private static final double CENTRE_Y = 55;
  private static final double CENTRE_Z = 66;
  private static final double RADIUS_X = 42;
  private static final double RADIUS_Y = 50;
  private static final double HALF_WIDTH = 6.5;
  private static final double HALF_HEIGHT = 11;
  private static final double WALL = 3;

  /** The wall in small cubes, voxels. */
  private static final double LEAST_WALL_VOXELS = 2;

  /** The rise of both ends, and the angle from the middle of the arch at which it begins. */
  private static final double RISE = 26;

  private static final double RISE_FROM_RAD = 0.95;
  private static final double END_RAD = 1.62;

  /** The distance of trabeculae along the arch, rad, and the fraction that they fill. */
  private static final double TRABECULA_RAD = 0.13;

  private static final double TRABECULA_FRACTION = 0.3;

  private JawArch() {}

  /** Returns the voxels of the bone in a cube of the given edge. */
  static BitCube bone(int edge) {
    BitCube bits = new BitCube(edge, edge, edge);
    double mm = NOMINAL_EDGE / edge;
    for (int j = 0; j < edge; j++) {
      for (int i = 0; i < edge; i++) {
        column(bits, i, j, mm);
      }
    }
    return bits;
  }

  private static void column(BitCube bits, int i, int j, double mm) {
    double x = ((i + 0.5) * mm - CENTRE_X) / RADIUS_X;
    double y = ((j + 0.5) * mm - CENTRE_Y) / RADIUS_Y;
    double side = (Math.sqrt(x * x + y * y) - 1) * (RADIUS_X + RADIUS_Y) / 2;
    double angle = StrictMath.atan2(x, y); // 0 at the chin
    double width = HALF_WIDTH + 1.2 * StrictMath.cos(2 * angle);
    if (Math.abs(side) >= width || Math.abs(angle) > END_RAD) {
      return;
    }
    double toEnd = Math.max(0, (Math.abs(angle) - RISE_FROM_RAD) / (END_RAD - RISE_FROM_RAD));
    double middleZ = CENTRE_Z + RISE * toEnd * toEnd;
    double height = HALF_HEIGHT + 2.5 * StrictMath.cos(3 * angle);
    double wall = Math.max(WALL, LEAST_WALL_VOXELS * mm);
    double along = Math.abs(angle) / TRABECULA_RAD;
    boolean isPlate =
        along - Math.floor(along) < TRABECULA_FRACTION
            || END_RAD - Math.abs(angle) < wall / RADIUS_X;
    int last = (int) Math.min(bits.sizeZ() - 1, (middleZ + height) / mm);
    for (int k = (int) ((middleZ - height) / mm); k <= last; k++) {
      double z = (k + 0.5) * mm - middleZ;
      boolean isMarrow =
          !isPlate && square(side / (width - wall)) + square(z / (height - wall)) < 1;
      if (!isMarrow && square(side / width) + square(z / height) < 1) {
        bits.set(i, j, k);
      }
    }
  }

  private static double square(double value) {
    return value * value;
  }
}
