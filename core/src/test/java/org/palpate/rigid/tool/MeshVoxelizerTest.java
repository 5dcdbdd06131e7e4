package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class MeshVoxelizerTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aCentreIsInsideIfTheMeshTurnsAroundIt() {
    for (int round = 0; round < 30; round++) {
      TriangleMesh mesh = randomMesh(round);
      double edge = random.nextDouble(0.4, 0.9);
      MeshVoxelizer voxelizer = new MeshVoxelizer(mesh, edge);
      voxelizer.fillInside();
      BitCube bits = voxelizer.bits();
      Vec3 low = mesh.low().sub(new Vec3(edge, edge, edge), new Vec3());
      int inside = 0;
      for (int n = 0; n < bits.sizeX() * bits.sizeY() * bits.sizeZ(); n++) {
        int i = n % bits.sizeX();
        int j = n / bits.sizeX() % bits.sizeY();
        int k = n / bits.sizeX() / bits.sizeY();
        Vec3 centre =
            new Vec3(low.x + (i + 0.5) * edge, low.y + (j + 0.5) * edge, low.z + (k + 0.5) * edge);
        boolean expected = windingNumber(mesh, centre) != 0;
        assertEquals(expected, bits.get(i, j, k), "round " + round + " at " + centre);
        inside += expected ? 1 : 0;
      }
      assertTrue(inside > 20);
    }
  }

  private TriangleMesh randomMesh(int round) {
    Quaternion turn = new Quaternion();
    turn.setRotationVector(RandomGeometry.vector(random, 3));
    return switch (round % 3) {
      case 0 -> TestMeshes.turned(TestMeshes.box(4, 5, 3), turn, RandomGeometry.vector(random, 10));
      case 1 ->
          TestMeshes.turned(
              TestMeshes.ball(2.5, RandomGeometry.vector(random, 9), 2),
              turn,
              RandomGeometry.vector(random, 10));
      default -> twoThatOverlap(turn);
    };
  }

  private TriangleMesh twoThatOverlap(Quaternion turn) {
    TriangleMesh a = TestMeshes.turned(TestMeshes.box(4, 2, 3), turn, new Vec3());
    TriangleMesh b = TestMeshes.ball(2, new Vec3(1, 1, 1), 1);
    double[] coordinates = new double[a.coordinates().length + b.coordinates().length];
    System.arraycopy(a.coordinates(), 0, coordinates, 0, a.coordinates().length);
    System.arraycopy(
        b.coordinates(), 0, coordinates, a.coordinates().length, b.coordinates().length);
    int[] corners = new int[a.corners().length + b.corners().length];
    System.arraycopy(a.corners(), 0, corners, 0, a.corners().length);
    for (int n = 0; n < b.corners().length; n++) {
      corners[a.corners().length + n] = b.corners()[n] + a.coordinates().length / 3;
    }
    return new TriangleMesh(coordinates, corners);
  }

  /** Returns the winding number as the sum of the solid angles of all triangles. */
  private static long windingNumber(TriangleMesh mesh, Vec3 p) {
    double sum = 0;
    Vec3 a = new Vec3();
    Vec3 b = new Vec3();
    Vec3 c = new Vec3();
    for (int n = 0; n < mesh.triangleCount(); n++) {
      mesh.corner(n, 0, a).sub(p, a);
      mesh.corner(n, 1, b).sub(p, b);
      mesh.corner(n, 2, c).sub(p, c);
      double la = a.length();
      double lb = b.length();
      double lc = c.length();
      double volume =
          a.x * (b.y * c.z - b.z * c.y)
              + a.y * (b.z * c.x - b.x * c.z)
              + a.z * (b.x * c.y - b.y * c.x);
      sum += 2 * Math.atan2(volume, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return Math.round(sum / (4 * Math.PI));
  }

  @Test
  void facesEdgesAndVerticesThroughCentresLeaveNoGapAndCountOnce() {
    for (double edge : new double[] {0.25, 0.5, 1}) {
      // Faces lie at multiples of the half edge, so that rays run through vertices and edges.
      TriangleMesh box = TestMeshes.box(4, 3, 5);
      MeshVoxelizer voxelizer = new MeshVoxelizer(box, edge);
      voxelizer.fillInside();
      BitCube bits = voxelizer.bits();
      long expected = Math.round(4 / edge) * Math.round(3 / edge) * Math.round(5 / edge);
      assertEquals(expected, bits.solidCount());
      TriangleMesh octahedron = TestMeshes.ball(2, new Vec3(0, 0, 0), 0);
      MeshVoxelizer tied = new MeshVoxelizer(octahedron, edge);
      tied.fillInside();
      assertEveryColumnIsOnePiece(tied.bits());
      double volume = tied.bits().solidCount() * edge * edge * edge;
      assertEquals(32.0 / 3, volume, edge < 1 ? 1.5 : 7);
    }
  }

  private static void assertEveryColumnIsOnePiece(BitCube bits) {
    for (int n = 0; n < bits.sizeX() * bits.sizeY(); n++) {
      int changes = 0;
      for (int k = 0; k < bits.sizeZ(); k++) {
        boolean here = bits.get(n % bits.sizeX(), n / bits.sizeX(), k);
        changes += here != bits.get(n % bits.sizeX(), n / bits.sizeX(), k - 1) ? 1 : 0;
      }
      assertTrue(changes == 0 || changes == 2, "changes " + changes);
    }
  }

  @Test
  void theVoxelsContainTheWholeSolidHoweverThin() {
    for (int round = 0; round < 10; round++) {
      TriangleMesh blade = blade();
      RigidTool tool = ToolSampler.ofClosedMesh(blade, 0.7, 0);
      Vec3 reference = tool.referenceMm(new Vec3());
      for (int n = 0; n < 2000; n++) {
        Vec3 p = turnedPoint(blade);
        p.sub(reference, p);
        assertTrue(tool.solid().contains(p.x, p.y, p.z), "at " + p);
      }
    }
  }

  @Test
  void aBodyTakesTheVoxelsWhoseCentresLieInsideAndLosesNoThinPart() {
    for (int round = 0; round < 30; round++) {
      TriangleMesh mesh = round % 5 == 4 ? blade() : randomMesh(round);
      double edge = random.nextDouble(0.4, 0.9);
      VoxelSolid body = MeshVoxelizer.onMultiples(mesh, edge).voxelizeBody();
      MeshVoxelizer centres = MeshVoxelizer.onMultiples(mesh, edge);
      centres.fillInside();
      BitCube whole = MeshVoxelizer.onMultiples(mesh, edge).voxelize().bits();
      Vec3 corner = body.grid().gridToWorld(new Vec3(), new Vec3());
      assertEquals(0, Math.IEEEremainder(corner.x, edge), 1e-9);
      BitCube bits = body.bits();
      for (int n = 0; n < bits.sizeX() * bits.sizeY() * bits.sizeZ(); n++) {
        int i = n % bits.sizeX();
        int j = n / bits.sizeX() % bits.sizeY();
        int k = n / bits.sizeX() / bits.sizeY();
        Vec3 centre = body.grid().gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
        boolean inside = windingNumber(mesh, centre) != 0;
        boolean alone = !anyAround(centres.bits(), i, j, k);
        assertEquals(inside || (alone && whole.get(i, j, k)), bits.get(i, j, k), "at " + centre);
      }
      assertTrue(bits.solidCount() > 5);
    }
  }

  private static boolean anyAround(BitCube bits, int i, int j, int k) {
    boolean found = false;
    for (int dz = -1; dz <= 1; dz++) {
      for (int dy = -1; dy <= 1; dy++) {
        for (int dx = -1; dx <= 1; dx++) {
          found |= bits.get(i + dx, j + dy, k + dz);
        }
      }
    }
    return found;
  }

  private TriangleMesh blade() {
    Quaternion turn = new Quaternion();
    turn.setRotationVector(RandomGeometry.vector(random, 3));
    return TestMeshes.turned(TestMeshes.box(8, 3, 0.05), turn, RandomGeometry.vector(random, 5));
  }

  @Test
  void halvesOfABoxThatShareAFaceShareNoVoxel() {
    double edge = 0.7;
    TriangleMesh left = TestMeshes.box(4, 3, 5);
    TriangleMesh right = TestMeshes.turned(left, new Quaternion(), new Vec3(4, 0, 0));
    VoxelSolid one = MeshVoxelizer.onMultiples(left, edge).voxelizeBody();
    VoxelSolid other = MeshVoxelizer.onMultiples(right, edge).voxelizeBody();
    Vec3 p = new Vec3();
    one.forEachSolid(
        (i, j, k) -> {
          one.grid().gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
          other.grid().worldToGrid(p, p);
          assertEquals(
              false,
              other
                  .bits()
                  .get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z)));
        });
    TriangleMesh both = TestMeshes.box(8, 3, 5);
    assertEquals(
        MeshVoxelizer.onMultiples(both, edge).voxelizeBody().bits().solidCount(),
        one.bits().solidCount() + other.bits().solidCount());
  }

  /** Returns a random point of a box that may be turned: the first vertex and three edges. */
  private Vec3 turnedPoint(TriangleMesh box) {
    double[] c = box.coordinates();
    Vec3 p = new Vec3(c[0], c[1], c[2]);
    for (int axis = 0; axis < 3; axis++) {
      int at = 3 * (1 << axis);
      double part = random.nextDouble(0.001, 0.999);
      Vec3 edge = new Vec3(c[at] - c[0], c[at + 1] - c[1], c[at + 2] - c[2]);
      p.add(edge.mul(part, edge), p);
    }
    return p;
  }

  @Test
  void samplesOfAnOpenSurfaceCoverItAndKeepApart() {
    for (double cover : new double[] {0.3, 1}) {
      TriangleMesh sheet =
          new TriangleMesh(
              new double[] {0, 0, 0, 9, 0, 0, 9, 0.02, 4, 0, 6, 0, 9, 6, 4},
              new int[] {0, 1, 4, 0, 4, 3, 1, 2, 4});
      RigidTool tool = ToolSampler.ofSurface(sheet, cover);
      Vec3 reference = tool.referenceMm(new Vec3());
      for (int n = 0; n < 1500; n++) {
        Vec3 p = surfacePoint(sheet).sub(reference, new Vec3());
        double nearest = Double.POSITIVE_INFINITY;
        for (int q = 0; q < tool.count(); q++) {
          nearest = Math.min(nearest, tool.point(q, new Vec3()).sub(p, new Vec3()).length());
        }
        assertTrue(nearest <= cover, "nearest " + nearest);
      }
      assertTrue(tool.count() < 3 * sheet.areaMm2() / (cover * cover), "points " + tool.count());
    }
  }

  private Vec3 surfacePoint(TriangleMesh mesh) {
    int n = random.nextInt(mesh.triangleCount());
    double u = random.nextDouble();
    double v = random.nextDouble(1 - u);
    Vec3 p = mesh.corner(n, 0, new Vec3()).mul(1 - u - v, new Vec3());
    p.add(mesh.corner(n, 1, new Vec3()).mul(u, new Vec3()), p);
    return p.add(mesh.corner(n, 2, new Vec3()).mul(v, new Vec3()), p);
  }

  @Test
  void anOpenMeshIsNotVoxelized() {
    TriangleMesh triangle =
        new TriangleMesh(new double[] {0, 0, 0, 1, 0, 0, 0, 1, 0}, new int[] {0, 1, 2});
    assertThrows(IllegalArgumentException.class, () -> ToolSampler.ofClosedMesh(triangle, 1, 0));
  }
}
