package org.palpate.scene.gl;

import java.util.List;
import org.palpate.geometry.Vec3;

/** Triangles of balls, tubes and cones, rebuilt for each picture. Scene frame, mm. */
final class MarkMesh extends ColouredVertices {
  /** A position and a normal. */
  private static final int FLOATS_BEFORE_COLOUR = 6;

  private static final int AROUND = 14;
  private static final int BALL_RINGS = 10;
  private static final int BALL_AROUND = 20;

  MarkMesh() {
    super(FLOATS_BEFORE_COLOUR);
  }

  /** Sets the colour of the following shapes, 0xRRGGBB, and their opacity. */
  MarkMesh colour(int rgb, double opacity) {
    setColour(rgb, opacity);
    return this;
  }

  /** Adds a ball. */
  void ball(Vec3 middle, double radius) {
    for (int ring = 0; ring < BALL_RINGS; ring++) {
      for (int i = 0; i < BALL_AROUND; i++) {
        Vec3 a = onBall(ring, i);
        Vec3 b = onBall(ring + 1, i);
        Vec3 c = onBall(ring + 1, i + 1);
        Vec3 d = onBall(ring, i + 1);
        for (Vec3 n : new Vec3[] {a, b, c, a, c, d}) {
          vertex(offset(middle, n, radius), n);
        }
      }
    }
  }

  /** Adds a small octahedron, a cheap mark for many points. */
  void dot(Vec3 middle, double radius) {
    for (int octant = 0; octant < 8; octant++) {
      Vec3 a = new Vec3((octant & 1) == 0 ? 1 : -1, 0, 0);
      Vec3 b = new Vec3(0, (octant & 2) == 0 ? 1 : -1, 0);
      Vec3 c = new Vec3(0, 0, (octant & 4) == 0 ? 1 : -1);
      for (Vec3 n : new Vec3[] {a, b, c}) {
        vertex(offset(middle, n, radius), n);
      }
    }
  }

  private static Vec3 onBall(int ring, int i) {
    double polar = Math.PI * ring / BALL_RINGS;
    double turn = 2 * Math.PI * i / BALL_AROUND;
    return new Vec3(
        Math.sin(polar) * Math.cos(turn), Math.sin(polar) * Math.sin(turn), Math.cos(polar));
  }

  /** Adds a round bar, or a cone if the radii differ. */
  private void bar(Vec3 from, Vec3 to, double fromRadius, double toRadius) {
    Vec3 axis = to.sub(from, new Vec3());
    double length = axis.length();
    if (!(length > 0)) {
      return;
    }
    axis.mul(1 / length, axis);
    Vec3 u = perpendicularTo(axis);
    Vec3 v = axis.cross(u, new Vec3());
    double lean = (fromRadius - toRadius) / length;
    for (int i = 0; i < AROUND; i++) {
      Vec3 side = onCircle(u, v, i);
      Vec3 next = onCircle(u, v, i + 1);
      Vec3 n = offset(side, axis, lean);
      Vec3 m = offset(next, axis, lean);
      Vec3 a = offset(from, side, fromRadius);
      Vec3 b = offset(from, next, fromRadius);
      Vec3 c = offset(to, next, toRadius);
      Vec3 d = offset(to, side, toRadius);
      vertex(a, n);
      vertex(b, m);
      vertex(c, m);
      vertex(a, n);
      vertex(c, m);
      vertex(d, n);
      vertex(from, back(axis));
      vertex(b, back(axis));
      vertex(a, back(axis));
    }
  }

  /** Adds a tube through points. */
  void tube(List<Vec3> points, double radius) {
    for (int i = 0; i + 1 < points.size(); i++) {
      bar(points.get(i), points.get(i + 1), radius, radius);
    }
  }

  /** Adds a spring with a number of turns. */
  void spring(Vec3 from, Vec3 to, int turns, double coilRadius, double wireRadius) {
    Vec3 axis = to.sub(from, new Vec3());
    double length = axis.length();
    if (!(length > 0)) {
      return;
    }
    Vec3 u = perpendicularTo(axis.mul(1 / length, axis));
    Vec3 v = axis.cross(u, new Vec3());
    int steps = 12 * turns;
    Vec3 last = from;
    for (int i = 1; i <= steps; i++) {
      double fraction = (double) i / steps;
      double swell = Math.min(1, 6 * Math.min(fraction, 1 - fraction)) * coilRadius;
      double angle = 2 * Math.PI * turns * fraction;
      Vec3 at = offset(from, axis, fraction * length);
      at = offset(offset(at, u, swell * Math.cos(angle)), v, swell * Math.sin(angle));
      bar(last, at, wireRadius, wireRadius);
      last = at;
    }
  }

  /** Adds an arrow. Its head takes at most half of its length. */
  void arrow(Vec3 from, Vec3 to, double radius) {
    Vec3 axis = to.sub(from, new Vec3());
    double length = axis.length();
    if (!(length > 0)) {
      return;
    }
    double head = Math.min(length / 2, 6 * radius);
    Vec3 neck = offset(from, axis, (length - head) / length);
    bar(from, neck, radius, radius);
    bar(neck, to, 2.6 * radius, 0);
  }

  private static Vec3 onCircle(Vec3 u, Vec3 v, int i) {
    double angle = 2 * Math.PI * i / AROUND;
    return offset(u.mul(Math.cos(angle), new Vec3()), v, Math.sin(angle));
  }

  private static Vec3 perpendicularTo(Vec3 axis) {
    Vec3 helper = Math.abs(axis.x) < 0.7 ? new Vec3(1, 0, 0) : new Vec3(0, 1, 0);
    Vec3 u = axis.cross(helper, new Vec3());
    return u.mul(1 / u.length(), u);
  }

  private static Vec3 back(Vec3 axis) {
    return axis.mul(-1, new Vec3());
  }

  private static Vec3 offset(Vec3 from, Vec3 direction, double distance) {
    return new Vec3(
        from.x + direction.x * distance,
        from.y + direction.y * distance,
        from.z + direction.z * distance);
  }

  private void vertex(Vec3 at, Vec3 normal) {
    beginVertex();
    put(at.x);
    put(at.y);
    put(at.z);
    put(normal.x);
    put(normal.y);
    put(normal.z);
    endVertex();
  }
}
