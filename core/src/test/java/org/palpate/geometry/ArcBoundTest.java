package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

/** Compares the swept ball of a body that turns with the chords that the body sees. */
class ArcBoundTest {
  /** The rounding of a distance in this test, mm. */
  private static final double ROUNDING_MM = 1e-8;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Pose from = new Pose();
  private final Pose to = new Pose();
  private final Vec3 shift = new Vec3();

  /** A unit vector across the shift. */
  private final Vec3 across = new Vec3();

  @Test
  void chordsOfPointsOutsideTheSweptBallDoNotMeetTheBody() {
    int needed = 0;
    for (int n = 0; n < 100_000; n++) {
      setMotion(Math.pow(10, random.nextDouble(-7, -0.1)), Math.pow(10, random.nextDouble(-2, 3)));
      double radiusMm = Math.pow(10, random.nextDouble(-1, 3));
      double sweptMm = ArcBound.sweptRadiusMm(radiusMm, shift.length(), from.rotation, to.rotation);
      double along = random.nextDouble();
      double leastMm = distanceOfChord(pointBeside(along, sweptMm));
      assertTrue(leastMm >= radiusMm - ROUNDING_MM, () -> "seed " + Seeds.seed() + " " + to);
      needed += distanceOfChord(pointBeside(along, radiusMm)) < radiusMm - 1e-6 ? 1 : 0;
    }
    assertTrue(needed > 10_000, "chords that meet the ball that is not widened: " + needed);
  }

  /** Sets a motion whose chords bend as far as they can, or one about any axis. */
  private void setMotion(double turnRad, double shiftMm) {
    from.set(RandomGeometry.pose(random, 10));
    scaled(RandomGeometry.vector(random, 1), shiftMm, shift);
    scaled(shift.cross(RandomGeometry.vector(random, 1), new Vec3()), 1, across);
    Vec3 axis =
        random.nextBoolean()
            ? RandomGeometry.vector(random, 1)
            : shift.cross(across, new Vec3()).mul(random.nextBoolean() ? 1 : -1, new Vec3());
    Quaternion turn = new Quaternion().setRotationVector(scaled(axis, turnRad, axis));
    turn.multiply(from.rotation, to.rotation);
    from.translation.add(shift, to.translation);
    stretch(from.rotation);
    stretch(to.rotation);
  }

  private static Vec3 scaled(Vec3 v, double length, Vec3 dest) {
    return v.mul(length / v.length(), dest);
  }

  /** Changes the norm as far as a unit quaternion allows. */
  private void stretch(Quaternion q) {
    double norm = 1 + random.nextInt(-1, 2) * 4e-13;
    q.set(norm * q.w, norm * q.x, norm * q.y, norm * q.z);
    assertTrue(q.isUnit());
  }

  /** Returns a point at a distance from the straight path of the reference point. */
  private Vec3 pointBeside(double along, double distanceMm) {
    Vec3 point = shift.mul(along, new Vec3());
    point.add(across.mul(distanceMm, new Vec3()), point);
    return point.add(from.translation, point);
  }

  /** Returns the distance between the chord of a point, as the body sees it, and the reference. */
  private double distanceOfChord(Vec3 point) {
    Vec3 begin = from.inverseTransform(point, new Vec3());
    Vec3 chord = to.inverseTransform(point, new Vec3()).sub(begin, new Vec3());
    double square = chord.dot(chord);
    double nearest = square > 0 ? Math.max(0, Math.min(1, -begin.dot(chord) / square)) : 0;
    return begin.add(chord.mul(nearest, chord), begin).length();
  }
}
