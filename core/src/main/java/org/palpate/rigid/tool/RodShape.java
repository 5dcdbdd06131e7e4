package org.palpate.rigid.tool;

import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * A rod along z with flat or round ends: a cylinder, a capsule, a sphere or a needle. Its straight
 * part reaches from {@code lowZ} to {@code highZ}; a round end is a half sphere beyond that.
 *
 * @param radius the radius of the rod and of its round ends, mm, positive
 * @param lowZ the low end of the straight part, mm
 * @param highZ the high end of the straight part, mm; equal to {@code lowZ} only for a sphere
 * @param roundLow whether the end at low z is a half sphere
 * @param roundHigh whether the end at high z is a half sphere
 */
public record RodShape(
    double radius, double lowZ, double highZ, boolean roundLow, boolean roundHigh)
    implements ToolShape {
  /** A sample is on the side if its squared distance from the axis lacks at most this part. */
  private static final double ON_SIDE = 1e-9;

  /**
   * The lowest point is searched within this angle around a sample. Beyond it, in a hole that is
   * hardly wider than the rod, contacts would leave the wall that they touch.
   */
  private static final double REACH_RAD = 0.32;

  /** Directions with a smaller part across the axis count as being along it. */
  private static final double LEAST_ACROSS = 0.1;

  /**
   * Checks radius and length.
   *
   * @throws IllegalArgumentException if the radius or the length is not positive and finite; the
   *     length may be 0 between two round ends
   */
  public RodShape {
    double length = highZ - lowZ;
    boolean mayBeEmpty = roundLow && roundHigh;
    if (!(radius > 0 && radius < Double.POSITIVE_INFINITY)
        || !(length >= 0 && length < Double.POSITIVE_INFINITY)
        || (length == 0 && !mayBeEmpty)) {
      throw new IllegalArgumentException(
          "radius and length of a rod must be positive: radius=" + radius + " length=" + length);
    }
  }

  /**
   * {@return a sphere around the origin}
   *
   * @param radiusMm the radius, mm, positive
   */
  public static RodShape sphere(double radiusMm) {
    return new RodShape(radiusMm, 0, 0, true, true);
  }

  /**
   * {@return a capsule: a cylinder around the origin between two half spheres}
   *
   * @param radiusMm the radius, mm, positive
   * @param lengthMm the length of the cylinder, mm
   */
  public static RodShape capsule(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, -lengthMm / 2, lengthMm / 2, true, true);
  }

  /**
   * {@return a cylinder with flat ends around the origin}
   *
   * @param radiusMm the radius, mm, positive
   * @param lengthMm the length along z, mm
   */
  public static RodShape cylinder(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, -lengthMm / 2, lengthMm / 2, false, false);
  }

  /**
   * {@return a needle: a cylinder around the origin, with a half sphere as its tip at low z}
   *
   * @param radiusMm the radius, mm, positive
   * @param lengthMm the length of the cylinder along z, mm
   */
  public static RodShape needle(double radiusMm, double lengthMm) {
    return new RodShape(radiusMm, -lengthMm / 2, lengthMm / 2, true, false);
  }

  private double length() {
    return highZ - lowZ;
  }

  @Override
  public boolean contains(double x, double y, double z) {
    double below = lowZ - z;
    double above = z - highZ;
    double beyond = Math.max(0, Math.max(below, above));
    boolean isRound = below > above ? roundLow : roundHigh;
    return (beyond == 0 || isRound) && x * x + y * y + beyond * beyond <= radius * radius;
  }

  @Override
  public Vec3 low() {
    return new Vec3(-radius, -radius, roundLow ? lowZ - radius : lowZ);
  }

  @Override
  public Vec3 high() {
    return new Vec3(radius, radius, roundHigh ? highZ + radius : highZ);
  }

  @Override
  public double areaMm2() {
    double ends = (roundLow ? 2 : 1) + (roundHigh ? 2 : 1);
    return Math.PI * radius * (2 * length() + ends * radius);
  }

  @Override
  public MassProperties massProperties() {
    MassProperties sum = null;
    if (length() > 0) {
      double across = radius * radius / 4;
      double along = length() * length() / 12;
      double volume = Math.PI * radius * radius * length();
      Vec3 middle = new Vec3(0, 0, lowZ + length() / 2);
      sum = new MassProperties(volume, middle, across, across, along, 0, 0, 0);
    }
    sum = roundLow ? plus(sum, halfSphere(lowZ, -1)) : sum;
    return roundHigh ? plus(sum, halfSphere(highZ, 1)) : sum;
  }

  private static MassProperties plus(MassProperties sum, MassProperties part) {
    return sum == null ? part : MassProperties.sum(sum, part);
  }

  private MassProperties halfSphere(double centreZ, int side) {
    double offset = 3.0 / 8 * radius;
    double across = radius * radius / 5;
    double along = across - offset * offset;
    return new MassProperties(
        2.0 / 3 * Math.PI * radius * radius * radius,
        new Vec3(0, 0, centreZ + side * offset),
        across,
        across,
        along,
        0,
        0,
        0);
  }

  @Override
  public Optional<ToolShape> eroded(double depthMm) {
    double low = roundLow ? lowZ : lowZ + depthMm;
    double high = roundHigh ? highZ : highZ - depthMm;
    boolean isLeft = radius > depthMm && (low < high || (low == high && roundLow && roundHigh));
    return isLeft
        ? Optional.of(new RodShape(radius - depthMm, low, high, roundLow, roundHigh))
        : Optional.empty();
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
    if (roundLow) {
      sampleHalfSphere(lowZ, -1, step, sink);
    } else {
      sampleDisk(lowZ, step, sink);
    }
    if (length() > 0) {
      sampleSide(step, sink);
    }
    if (roundHigh) {
      sampleHalfSphere(highZ, 1, step, sink);
    } else {
      sampleDisk(highZ, step, sink);
    }
  }

  /**
   * {@inheritDoc}
   *
   * <p>The surface is curved at the round ends, which together are a ball if the rod has no length,
   * and along the circles of the side. A circle has no lowest point along the axis of the rod.
   */
  @Override
  public Vec3 lowestNear(Vec3 sample, Vec3 up, double withinMm, Vec3 dest) {
    boolean isBall = length() == 0;
    boolean isLow = roundLow && sample.z <= lowZ && (isBall || up.z >= 0);
    boolean isHigh = roundHigh && sample.z >= highZ && (isBall || up.z <= 0);
    double x = sample.x;
    double y = sample.y;
    double z = sample.z;
    double across = Math.sqrt(up.x * up.x + up.y * up.y);
    if (isLow || isHigh) {
      dest.set(-radius * up.x, -radius * up.y, (isLow ? lowZ : highZ) - radius * up.z);
    } else if (across >= LEAST_ACROSS && (isOnSide(sample) || z < lowZ || z > highZ)) {
      double inside = Math.max(lowZ, Math.min(highZ, z));
      dest.set(-radius / across * up.x, -radius / across * up.y, inside);
    } else {
      return dest.set(sample);
    }
    double reach = Math.max(withinMm, REACH_RAD * radius);
    return squaredDistance(dest, x, y, z) <= reach * reach ? dest : dest.set(x, y, z);
  }

  private static double squaredDistance(Vec3 p, double x, double y, double z) {
    return (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y) + (p.z - z) * (p.z - z);
  }

  private boolean isOnSide(Vec3 p) {
    return p.x * p.x + p.y * p.y >= radius * radius * (1 - ON_SIDE);
  }

  /** Samples from the pole to the equator, which belongs to the side if there is one. */
  private void sampleHalfSphere(double centreZ, int side, double step, PointSink sink) {
    int bands = Math.max(1, (int) Math.ceil(Math.PI / 2 * radius / step));
    boolean ownsEquator = length() == 0 && side > 0;
    for (int n = 0; n < bands + (ownsEquator ? 1 : 0); n++) {
      double angle = Math.PI / 2 * n / bands; // from the pole
      double widest = Math.min(Math.PI / 2, Math.PI / 2 * (n + 0.5) / bands);
      double z = centreZ + side * radius * StrictMath.cos(angle);
      sampleRing(radius * StrictMath.sin(angle), radius * StrictMath.sin(widest), z, step, n, sink);
    }
  }

  private void sampleSide(double step, PointSink sink) {
    int bands = Math.max(1, (int) Math.ceil(length() / step));
    int first = roundLow ? 0 : 1; // the rims belong to the disks
    int last = roundHigh ? bands : bands - 1;
    for (int n = first; n <= last; n++) {
      sampleRing(radius, radius, lowZ + length() * n / bands, step, n, sink);
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
      sink.add(ringRadius * StrictMath.cos(angle), ringRadius * StrictMath.sin(angle), z);
    }
  }
}
