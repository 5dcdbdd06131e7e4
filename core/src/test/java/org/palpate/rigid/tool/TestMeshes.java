package org.palpate.rigid.tool;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/** Meshes with known volumes. */
final class TestMeshes {
  private TestMeshes() {}

  /** Returns a cuboid from the origin, of 12 triangles that face outward. */
  static TriangleMesh box(double x, double y, double z) {
    return new TriangleMesh(boxCoordinates(x, y, z), boxCorners());
  }

  static double[] boxCoordinates(double x, double y, double z) {
    double[] coordinates = new double[24];
    for (int n = 0; n < 8; n++) {
      coordinates[3 * n] = (n & 1) * x;
      coordinates[3 * n + 1] = (n >> 1 & 1) * y;
      coordinates[3 * n + 2] = (n >> 2) * z;
    }
    return coordinates;
  }

  static int[] boxCorners() {
    return new int[] {
      0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1,
      3, 7, 1, 7, 5
    };
  }

  /** Returns a ball whose triangles are those of an octahedron, cut four to one some times. */
  static TriangleMesh ball(double radius, Vec3 centre, int cuts) {
    List<Vec3[]> triangles = new ArrayList<>();
    for (int n = 0; n < 8; n++) {
      Vec3 x = new Vec3((n & 1) == 0 ? 1 : -1, 0, 0);
      Vec3 y = new Vec3(0, (n >> 1 & 1) == 0 ? 1 : -1, 0);
      Vec3 z = new Vec3(0, 0, n >> 2 == 0 ? 1 : -1);
      boolean isEven = Integer.bitCount(n) % 2 == 0;
      triangles.add(isEven ? new Vec3[] {x, y, z} : new Vec3[] {y, x, z});
    }
    for (int cut = 0; cut < cuts; cut++) {
      List<Vec3[]> finer = new ArrayList<>();
      for (Vec3[] t : triangles) {
        Vec3 ab = middle(t[0], t[1]);
        Vec3 bc = middle(t[1], t[2]);
        Vec3 ca = middle(t[2], t[0]);
        finer.add(new Vec3[] {t[0], ab, ca});
        finer.add(new Vec3[] {ab, t[1], bc});
        finer.add(new Vec3[] {ca, bc, t[2]});
        finer.add(new Vec3[] {ab, bc, ca});
      }
      triangles = finer;
    }
    return soup(triangles, radius, centre, new Quaternion());
  }

  private static Vec3 middle(Vec3 a, Vec3 b) {
    Vec3 m = a.add(b, new Vec3());
    return m.mul(1 / m.length(), m);
  }

  /** Returns separate triangles, each with vertices of its own, scaled, turned and moved. */
  static TriangleMesh soup(List<Vec3[]> triangles, double scale, Vec3 shift, Quaternion turn) {
    double[] coordinates = new double[9 * triangles.size()];
    int[] corners = new int[3 * triangles.size()];
    Vec3 p = new Vec3();
    for (int n = 0; n < corners.length; n++) {
      turn.rotate(triangles.get(n / 3)[n % 3], p).mul(scale, p).add(shift, p);
      coordinates[3 * n] = p.x;
      coordinates[3 * n + 1] = p.y;
      coordinates[3 * n + 2] = p.z;
      corners[n] = n;
    }
    return new TriangleMesh(coordinates, corners);
  }

  /** Returns a mesh that is turned and moved. */
  static TriangleMesh turned(TriangleMesh mesh, Quaternion turn, Vec3 shift) {
    double[] coordinates = mesh.coordinates();
    Vec3 p = new Vec3();
    for (int n = 0; n < coordinates.length; n += 3) {
      p.set(coordinates[n], coordinates[n + 1], coordinates[n + 2]);
      turn.rotate(p, p).add(shift, p);
      coordinates[n] = p.x;
      coordinates[n + 1] = p.y;
      coordinates[n + 2] = p.z;
    }
    return new TriangleMesh(coordinates, mesh.corners());
  }
}
