package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;

class MeshMomentsTest {
  private static final double ROUNDING = 1e-12;
  private static final Vec3 LOW = new Vec3(10, 20, 30);

  /** The edges of the box, mm. */
  private static final Vec3 EDGES = new Vec3(2, 3, 5);

  /**
   * The corners of the two triangles of each face, outwards; bit n is the corner's side along n.
   */
  private static final int[][] FACES = {
    {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}
  };

  private static Vec3 corner(int bits) {
    return new Vec3(
        LOW.x + (bits & 1) * EDGES.x,
        LOW.y + (bits >> 1 & 1) * EDGES.y,
        LOW.z + (bits >> 2) * EDGES.z);
  }

  @Test
  void theMomentsOfABoxAreThoseOfItsEdgesWhereverTheOriginIs() {
    for (Vec3 origin : new Vec3[] {new Vec3(), LOW, new Vec3(11, 21, 32), new Vec3(-40, 5, 50)}) {
      MeshMoments moments = new MeshMoments(origin);
      for (int[] face : FACES) {
        moments.addTetrahedron(corner(face[0]), corner(face[1]), corner(face[2]));
        moments.addTetrahedron(corner(face[0]), corner(face[2]), corner(face[3]));
      }
      assertEquals(30, moments.size(), 1e-9);
      MassProperties box = moments.massProperties();
      assertMiddle(box.centroidMm());
      assertEquals(4 / 12.0, covariance(box, 0, 0), 1e-9);
      assertEquals(9 / 12.0, covariance(box, 1, 1), 1e-9);
      assertEquals(25 / 12.0, covariance(box, 2, 2), 1e-9);
      assertEquals(0, covariance(box, 0, 1), 1e-9);
      assertEquals(0, covariance(box, 0, 2), 1e-9);
      assertEquals(0, covariance(box, 1, 2), 1e-9);
    }
  }

  private static void assertMiddle(Vec3 centroid) {
    assertEquals(11, centroid.x, 1e-9);
    assertEquals(21.5, centroid.y, 1e-9);
    assertEquals(32.5, centroid.z, 1e-9);
  }

  @Test
  void theMomentsOfASheetAreThoseOfItsTriangle() {
    MeshMoments moments = new MeshMoments(new Vec3(1, 1, 1));
    moments.addTriangle(new Vec3(0, 0, 4), new Vec3(6, 0, 4), new Vec3(0, 6, 4));
    assertEquals(18, moments.size(), ROUNDING);
    MassProperties sheet = moments.massProperties();
    assertEquals(2, sheet.centroidMm().x, ROUNDING);
    assertEquals(2, sheet.centroidMm().y, ROUNDING);
    assertEquals(4, sheet.centroidMm().z, ROUNDING);
    assertEquals(36 / 18.0, covariance(sheet, 0, 0), ROUNDING);
    assertEquals(36 / 18.0, covariance(sheet, 1, 1), ROUNDING);
    assertEquals(0, covariance(sheet, 2, 2), ROUNDING);
    assertEquals(-36 / 36.0, covariance(sheet, 0, 1), ROUNDING);
    assertEquals(0, covariance(sheet, 0, 2), ROUNDING);
    assertEquals(0, covariance(sheet, 1, 2), ROUNDING);
  }

  /** A tetrahedron with legs of 6 mm has the variance 3 a^2 / 80 and the covariance -a^2 / 80. */
  @Test
  void aTetrahedronIsNotSymmetric() {
    MeshMoments moments = new MeshMoments(new Vec3());
    moments.addTetrahedron(new Vec3(6, 0, 0), new Vec3(0, 6, 0), new Vec3(0, 0, 6));
    assertEquals(36, moments.size(), ROUNDING);
    MassProperties solid = moments.massProperties();
    assertEquals(1.5, solid.centroidMm().z, ROUNDING);
    assertEquals(3 * 36 / 80.0, covariance(solid, 2, 2), ROUNDING);
    assertEquals(-36 / 80.0, covariance(solid, 0, 1), ROUNDING);
    assertEquals(-36 / 80.0, covariance(solid, 0, 2), ROUNDING);
    assertEquals(-36 / 80.0, covariance(solid, 1, 2), ROUNDING);
  }

  @Test
  void partsThatFaceTheOriginAreSubtracted() {
    MeshMoments moments = new MeshMoments(new Vec3());
    moments.addTetrahedron(new Vec3(0, 6, 0), new Vec3(6, 0, 0), new Vec3(0, 0, 6));
    assertEquals(-36, moments.size(), ROUNDING);
    moments.addTetrahedron(new Vec3(6, 0, 0), new Vec3(0, 6, 0), new Vec3(0, 0, 6));
    assertEquals(0, moments.size());
    assertEquals(0, moments.massProperties().centroidMm().length(), "the origin");
  }

  /** Returns the covariance along two axes, without the little that a metric adds to each axis. */
  private static double covariance(MassProperties of, int one, int other) {
    if (one != other) {
      return -inertia(of, one, other);
    }
    double sum = (inertia(of, 0, 0) + inertia(of, 1, 1) + inertia(of, 2, 2)) / 2;
    double radius = of.metric().rmsRadiusMm();
    double added = (sum - radius * radius) / 3;
    return sum - inertia(of, one, one) - added;
  }

  private static double inertia(MassProperties of, int one, int other) {
    Vec3 unit = new Vec3();
    unit.set(one, 1);
    return of.metric().inertiaTimes(unit, unit).get(other);
  }
}
