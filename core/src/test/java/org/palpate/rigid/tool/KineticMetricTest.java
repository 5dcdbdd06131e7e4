package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class KineticMetricTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final double[][] matter = new double[400][];
  private final KineticMetric metric;

  KineticMetricTest() {
    MomentSum moments = new MomentSum();
    double[] mean = new double[3];
    for (int n = 0; n < matter.length; n++) {
      matter[n] = new double[] {9 * random.nextDouble(), 4 * random.nextDouble(), 0};
      matter[n][2] = 7 * random.nextDouble() + 0.3 * matter[n][0];
      moments.add(matter[n][0], matter[n][1], matter[n][2]);
      for (int c = 0; c < 3; c++) {
        mean[c] += matter[n][c] / matter.length;
      }
    }
    assertEquals(mean[0], moments.massProperties().centroidMm().x, 1e-12);
    for (double[] p : matter) {
      for (int c = 0; c < 3; c++) {
        p[c] -= mean[c];
      }
    }
    metric = moments.massProperties().metric();
  }

  @Test
  void theDistanceIsTheRmsPathOfTheMatterUpToWhatRodsNeed() {
    for (int n = 0; n < 200; n++) {
      Pose a = RandomGeometry.pose(random, 3);
      Pose b = RandomGeometry.pose(random, 3);
      double sum = 0;
      double turned = 0;
      for (double[] m : matter) {
        Vec3 p = new Vec3(m[0], m[1], m[2]);
        Vec3 path = b.transform(p, new Vec3()).sub(a.transform(p, new Vec3()), new Vec3());
        sum += path.dot(path) / matter.length;
      }
      Quaternion q = a.rotation.conjugate(new Quaternion());
      turned = 8 * Math.pow(Math.sin(b.rotation.multiply(q, q).angle() / 2), 2);
      double added = 0.01 * Math.pow(metric.rmsRadiusMm(), 2) + 1e-3;
      assertEquals(sum + turned * added, metric.squaredDistance(a, b), 1e-9 * (1 + sum));
    }
  }

  @Test
  void aSpinHasTheEnergyOfTheMatterUpToWhatRodsNeed() {
    double added = 2 * (0.01 * Math.pow(metric.rmsRadiusMm(), 2) + 1e-3);
    for (int n = 0; n < 100; n++) {
      Vec3 spin = RandomGeometry.pose(random, 3).translation;
      double sum = added * spin.dot(spin);
      for (double[] m : matter) {
        Vec3 speed = spin.cross(new Vec3(m[0], m[1], m[2]), new Vec3());
        sum += speed.dot(speed) / matter.length;
      }
      assertEquals(sum, metric.squaredSpin(spin), 1e-9 * sum);
      assertEquals(sum, spin.dot(metric.inertiaTimes(spin, new Vec3())), 1e-9 * sum);
    }
  }

  @Test
  void aSolvedSpinHasTheGivenMoment() {
    for (int n = 0; n < 100; n++) {
      Vec3 moment = RandomGeometry.pose(random, 3).translation;
      double m = random.nextDouble();
      double s = random.nextDouble();
      Vec3 spin = metric.solve(m, s, moment, new Vec3());
      Vec3 back = metric.inertiaTimes(spin, new Vec3()).mul(m, new Vec3());
      back.add(spin.mul(s, new Vec3()), back);
      assertEquals(0, back.sub(moment, new Vec3()).length(), 1e-9 * moment.length());
    }
  }

  @Test
  void theDistanceOfAPoseToItselfIsNothing() {
    Pose a = RandomGeometry.pose(random, 3);
    assertEquals(0, metric.squaredDistance(a, a));
  }

  @Test
  void metricCoordinatesHaveTheLengthOfASmallTwist() {
    Quaternion scratch = new Quaternion();
    double[] y = new double[6];
    double[] back = new double[6];
    for (int n = 0; n < 200; n++) {
      Pose a = RandomGeometry.pose(random, 3);
      Vec3 v = RandomGeometry.vector(random, 1e-5);
      Vec3 w = RandomGeometry.vector(random, 1e-5);
      Pose b = a.displace(v, w, 1, scratch, new Pose());
      metric.toMetric(a, v, w, new Vec3(), y);
      double square = 0;
      for (double c : y) {
        square += c * c;
      }
      assertEquals(1, Math.sqrt(square) / metric.distance(a, b), 1e-4);
      Vec3 v2 = new Vec3();
      Vec3 w2 = new Vec3();
      metric.toTwist(a, y, v2, w2);
      metric.toMetric(a, v2, w2, new Vec3(), back);
      assertArrayEquals(y, back, 1e-18);
    }
  }

  @Test
  void aContactRowGivesTheMotionOfAPointAlongTheNormal() {
    double[] y = new double[6];
    double[] row = new double[9];
    for (int n = 0; n < 200; n++) {
      Pose pose = RandomGeometry.pose(random, 3);
      Vec3 v = RandomGeometry.vector(random, 1);
      Vec3 w = RandomGeometry.vector(random, 1);
      Vec3 p = RandomGeometry.vector(random, 9);
      Vec3 normal = RandomGeometry.vector(random, 1);
      normal.mul(1 / normal.length(), normal);
      metric.toMetric(pose, v, w, new Vec3(), y);
      metric.contactRow(pose, p.x, p.y, p.z, normal, new Vec3(), row, 2);
      double along = 0;
      for (int c = 0; c < 6; c++) {
        along += row[2 + c] * y[c];
      }
      Vec3 r = pose.rotation.rotate(p, new Vec3());
      Vec3 motion =
          new Vec3(
              v.x + w.y * r.z - w.z * r.y,
              v.y + w.z * r.x - w.x * r.z,
              v.z + w.x * r.y - w.y * r.x);
      assertEquals(normal.dot(motion), along, 1e-12 * 30);
    }
  }
}
