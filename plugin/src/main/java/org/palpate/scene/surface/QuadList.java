package org.palpate.scene.surface;

import java.util.Arrays;

/**
 * The quads of a padded brick in the order of their cells. Scratch memory of one {@link
 * SurfaceExtractor}.
 */
final class QuadList {
  /** Flag: the solid voxel is the lower one, so the normal points along the axis. */
  static final int OUTWARD = 1;

  /** Flag: the quad belongs to the brick, not to its padding. */
  static final int CORE = 2;

  int count;

  /** Four vertices around the edge, counter-clockwise seen from its high end. */
  int[] corner = new int[1 << 14];

  /** The axis times 4, plus flags. */
  private byte[] kind = new byte[1 << 12];

  /** Removes all quads. */
  void clear() {
    count = 0;
  }

  /** Adds a quad. */
  void add(int a, int b, int c, int d, int newKind) {
    if (count == kind.length) {
      corner = Arrays.copyOf(corner, 8 * count);
      kind = Arrays.copyOf(kind, 2 * count);
    }
    corner[4 * count] = a;
    corner[4 * count + 1] = b;
    corner[4 * count + 2] = c;
    corner[4 * count + 3] = d;
    kind[count++] = (byte) newKind;
  }

  /** Returns the axis of the edge that a quad surrounds. */
  int axis(int quad) {
    return kind[quad] >> 2;
  }

  /** Whether the solid voxel is the lower one. */
  boolean isOutward(int quad) {
    return (kind[quad] & OUTWARD) != 0;
  }

  /** Whether a quad belongs to the brick, not to its padding. */
  boolean isCore(int quad) {
    return (kind[quad] & CORE) != 0;
  }
}
