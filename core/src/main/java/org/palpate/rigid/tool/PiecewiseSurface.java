package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;

/** Cuts triangles at the middle of their longest edges until the pieces are short. One thread. */
final class PiecewiseSurface {
  /** The most times that a triangle is cut; each cut halves the longest of three edges. */
  private static final int MOST_CUTS = 96;

  private final double squaredLengthMm2;
  private final Vec3[][] stack = new Vec3[MOST_CUTS + 2][3];
  private final int[] cuts = new int[MOST_CUTS + 2];
  private final Vec3 middle = new Vec3();

  /** Takes the corners of a piece, which change after the call. */
  @FunctionalInterface
  interface PieceSink {
    /** Takes a piece, mm. */
    void take(Vec3 a, Vec3 b, Vec3 c);
  }

  /**
   * Creates a cutter.
   *
   * @param longestEdgeMm the longest edge of a piece, mm
   */
  PiecewiseSurface(double longestEdgeMm) {
    squaredLengthMm2 = longestEdgeMm * longestEdgeMm;
    for (Vec3[] triangle : stack) {
      for (int n = 0; n < 3; n++) {
        triangle[n] = new Vec3();
      }
    }
  }

  /** Cuts a triangle and passes its pieces on. Their union is the triangle, up to rounding. */
  void cut(Vec3 a, Vec3 b, Vec3 c, PieceSink sink) {
    set(0, a, b, c, 0);
    for (int top = 0; top >= 0; ) {
      Vec3[] t = stack[top];
      int longest = longestEdge(t);
      Vec3 from = t[longest];
      Vec3 to = t[(longest + 1) % 3];
      Vec3 apex = t[(longest + 2) % 3];
      boolean isShort = TriangleMath.squaredDistance(from, to) <= squaredLengthMm2;
      if (isShort || cuts[top] == MOST_CUTS) {
        sink.take(t[0], t[1], t[2]);
        top--;
      } else {
        from.add(to, middle).mul(0.5, middle);
        int depth = cuts[top] + 1;
        set(top + 1, middle, to, apex, depth);
        t[(longest + 1) % 3].set(middle);
        cuts[top] = depth;
        top++;
      }
    }
  }

  private void set(int at, Vec3 a, Vec3 b, Vec3 c, int depth) {
    stack[at][0].set(a);
    stack[at][1].set(b);
    stack[at][2].set(c);
    cuts[at] = depth;
  }

  private static int longestEdge(Vec3[] t) {
    double ab = TriangleMath.squaredDistance(t[0], t[1]);
    double bc = TriangleMath.squaredDistance(t[1], t[2]);
    double ca = TriangleMath.squaredDistance(t[2], t[0]);
    return ab >= bc && ab >= ca ? 0 : bc >= ca ? 1 : 2;
  }
}
