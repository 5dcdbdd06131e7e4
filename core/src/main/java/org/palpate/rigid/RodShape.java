package org.palpate.rigid;

import org.palpate.geometry.Vec3;

/**
 * A rod along z with flat or round ends: a cylinder, a capsule, a sphere (of length 0), a probe
 * with a round tip. The straight part goes from z = -length/2 to length/2; a round end stands out
 * by the radius.
 *
 * @param radius of the rod and of its round ends, mm, positive
 * @param length of the straight part, mm; 0 only between two round ends
 * @param roundLow whether the end at low z is a half sphere
 * @param roundHigh whether the end at high z is a half sphere
 */
public record RodShape(double radius, double length, boolean roundLow, boolean roundHigh)
    implements ToolShape {

  /** Checks radius and length. */
  public RodShape {
    boolean mayBeEmpty = roundLow && roundHigh;
    if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)
        || !(length >= 0 && length < Double.POSITIVE_INFINITY)
        || (length == 0 && !mayBeEmpty)) {
      throw new IllegalArgumentException(
          "radius and length of a rod must be positive: radius=" + radius + " length=" + length);
    }
  }

  /** Returns a sphere around the origin. */
  public static RodShape sphere(double radiusMm) {
    return new RodShape(radiusMm, 0, true, true);
  }

  /** Returns a capsule: a cylinder of this length between two half spheres. */
  public static RodShape capsule(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, lengthMm, true, true);
  }

  /** Returns a cylinder with flat ends. */
  public static RodShape cylinder(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, lengthMm, false, false);
  }

  /** Returns a cylinder of this length with a half sphere as its tip at low z. */
  public static RodShape probe(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, lengthMm, true, false);
  }

  @Override
  public boolean contains(double x, double y, double z) {
    double over = Math.abs(z) - length / 2;
    if (over <= 0) {
      return x * x + y * y <= radius * radius;
    }
    boolean round = z < 0 ? roundLow : roundHigh;
    return round && x * x + y * y + over * over <= radius * radius;
  }

  @Override
  public Vec3 low() {
    return new Vec3(-radius, -radius, -length / 2 - (roundLow ? radius : 0));
  }

  @Override
  public Vec3 high() {
    return new Vec3(radius, radius, length / 2 + (roundHigh ? radius : 0));
  }

  /**
   * {@inheritDoc}
   *
   * <p>The samples are rings. Their distance along the meridian is at most the step s, and so is
   * the distance of samples on a circle of the widest radius that the ring stands for. A surface
   * point at radius r then has a sample at radius r0, turned by an angle d, with (r - r0)^2 + dz^2
   * at most (s/2)^2 and r r0 d^2 at most (s/2)^2. The squared distance is the sum of the first and
   * of 2 r r0 (1 - cos d), so it is at most s^2/2.
   */
  @Override
  public void sampleSurface(double coverRadiusMm, PointSink sink) {
    double step = coverRadiusMm * Math.sqrt(2);
    double half = length / 2;
    if (roundLow) {
      sampleHalfSphere(-half, -1, step, sink);
    } else {
      sampleDisk(-half, step, sink);
    }
    if (length > 0) {
      sampleSide(step, sink);
    }
    if (roundHigh) {
      sampleHalfSphere(half, 1, step, sink);
    } else {
      sampleDisk(half, step, sink);
    }
  }

  /** Samples from the pole to the equator, which is left to the side if there is one. */
  private void sampleHalfSphere(double centreZ, int side, double step, PointSink sink) {
    int bands = Math.max(1, (int) Math.ceil(Math.PI / 2 * radius / step));
    boolean ownsEquator = length == 0 && side > 0;
    for (int n = 0; n < bands + (ownsEquator ? 1 : 0); n++) {
      double angle = Math.PI / 2 * n / bands; // from the pole
      double widest = Math.min(Math.PI / 2, Math.PI / 2 * (n + 0.5) / bands);
      double z = centreZ + side * radius * Math.cos(angle);
      sampleRing(radius * Math.sin(angle), radius * Math.sin(widest), z, step, n, sink);
    }
  }

  private void sampleSide(double step, PointSink sink) {
    int bands = Math.max(1, (int) Math.ceil(length / step));
    int first = roundLow ? 0 : 1; // the disks own their rims
    int last = roundHigh ? bands : bands - 1;
    for (int n = first; n <= last; n++) {
      sampleRing(radius, radius, length * n / bands - length / 2, step, n, sink);
    }
  }

  private void sampleDisk(double z, double step, PointSink sink) {
    int bands = Math.max(1, (int) Math.ceil(radius / step));
    for (int n = 0; n <= bands; n++) {
      double widest = Math.min(radius, radius * (n + 0.5) / bands);
      sampleRing(radius * n / bands, widest, z, step, n, sink);
    }
  }

  /** Samples a circle; every other ring is turned by half a step. */
  private static void sampleRing(
      double ringRadius, double widest, double z, double step, int index, PointSink sink) {
    if (ringRadius == 0) {
      sink.add(0, 0, z); // a pole stands for points whose squared distance is at most (s/2)^2
      return;
    }
    int count = Math.max(3, (int) Math.ceil(2 * Math.PI * widest / step));
    for (int n = 0; n < count; n++) {
      double angle = 2 * Math.PI * (n + 0.5 * (index & 1)) / count;
      sink.add(ringRadius * Math.cos(angle), ringRadius * Math.sin(angle), z);
    }
  }
}
