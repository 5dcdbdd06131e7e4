package org.palpate.scene.surface;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class SurfaceExtractorTest {
  private final long seed = Shapes.seed();
  private final Random random = new Random(seed);

  @Test
  void aSurfaceOfRandomVoxelsIsClosed() {
    for (int round = 0; round < 12; round++) {
      BitCube bits = Shapes.random(9, 8, 7, 0.1 + 0.8 * random.nextDouble(), random);
      assertClosed(Shapes.surface(SurfaceSource.ofBits(bits, new Vec3(1, 0.5, 2))));
    }
  }

  /** Compares with a plain reference: the winding number at a voxel's centre is 1 or 0. */
  @Test
  void everySolidVoxelCentreIsInsideAndEveryEmptyOneOutside() {
    for (int round = 0; round < 12; round++) {
      BitCube bits = Shapes.random(5, 5, 5, 0.15 + 0.7 * random.nextDouble(), random);
      WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
      for (int voxel = 0; voxel < 7 * 7 * 7; voxel++) {
        int i = voxel % 7 - 1;
        int j = voxel / 7 % 7 - 1;
        int k = voxel / 49 - 1;
        double winding = windingNumber(surface, i + 0.5, j + 0.5, k + 0.5);
        assertEquals(
            bits.get(i, j, k) ? 1 : 0, winding, 1e-6, "voxel " + i + "," + j + "," + k + said());
      }
    }
  }

  @Test
  void everyEdgeHasTwoTrianglesWhereNoTwoVoxelsShareOnlyAnEdge() {
    for (int round = 0; round < 200; round++) {
      BitCube bits = Shapes.random(4, 4, 4, random.nextDouble(), random);
      if (!hasEdgeContact(bits)) {
        WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
        edges(surface).values().forEach(count -> assertEquals(2, count[0] + count[1], said()));
      }
    }
    BitCube sphere = Shapes.sphere(20, 7.3);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(sphere, Shapes.UNIT));
    edges(surface).values().forEach(count -> assertEquals(2, count[0] + count[1]));
    assertEquals(2, surface.vertexCount() - surface.triangleCount() / 2, "Euler of a sphere");
  }

  @Test
  void twoVoxelsThatShareAnEdgeHaveOneSurface() {
    BitCube bits = new BitCube(4, 4, 3);
    bits.set(1, 1, 1);
    bits.set(2, 2, 1);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
    assertEquals(1, components(surface));
    assertClosed(surface);
  }

  @Test
  void twoVoxelsThatShareACornerHaveOneSurface() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(1, 2, 1);
    bits.set(2, 1, 2);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
    assertEquals(1, components(surface));
    assertClosed(surface);
  }

  @Test
  void twoEmptyVoxelsThatShareAnEdgeAreTwoHollows() {
    BitCube bits = Shapes.cube(6, 6, 5, (x, y, z) -> true);
    bits.clear(2, 2, 2);
    bits.clear(3, 3, 2);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
    assertClosed(surface);
    assertEquals(3, components(surface));
  }

  @Test
  void volumeAndAreaOfASphereAreRightToOnePercent() {
    double radius = 20;
    WeldedSurface surface =
        Shapes.surface(SurfaceSource.ofBits(Shapes.sphere(48, radius), Shapes.UNIT));
    double volume = 4.0 / 3 * Math.PI * Math.pow(radius, 3);
    double area = 4 * Math.PI * radius * radius;
    assertEquals(1, SurfaceMeasures.of(surface).volumeMm3() / volume, 0.01);
    assertEquals(1, SurfaceMeasures.of(surface).areaMm2() / area, 0.01);
  }

  @Test
  void volumeAndAreaOfATorusOnAnisotropicVoxelsAreRightToTwoPercent() {
    double ring = 24;
    double tube = 12;
    Vec3 spacing = new Vec3(1, 0.75, 2);
    BitCube bits =
        Shapes.cube(
            80,
            104,
            16,
            (x, y, z) ->
                Shapes.square(Math.hypot(x - 40, 0.75 * y - 39) - ring) + Shapes.square(2 * z - 16)
                    <= tube * tube);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, spacing));
    assertEquals(
        1,
        SurfaceMeasures.of(surface).volumeMm3() / (2 * Math.PI * Math.PI * ring * tube * tube),
        0.02);
    assertEquals(
        1, SurfaceMeasures.of(surface).areaMm2() / (4 * Math.PI * Math.PI * ring * tube), 0.02);
  }

  @Test
  void volumeAndAreaOfASphereOfGreyValuesAreRightToAThirdOfAPercent() {
    double radius = 20;
    BitCube bits = Shapes.sphere(48, radius);
    SurfaceSource source =
        new SurfaceSource(
            bits,
            new GreyEdgeCrossings(
                (i, j, k) -> (float) -distance(i, j, k, 24),
                (float) -radius,
                Float.POSITIVE_INFINITY),
            Shapes.UNIT,
            1);
    WeldedSurface surface = Shapes.surface(source);
    assertEquals(
        1,
        SurfaceMeasures.of(surface).volumeMm3() / (4.0 / 3 * Math.PI * Math.pow(radius, 3)),
        0.003);
    assertEquals(1, SurfaceMeasures.of(surface).areaMm2() / (4 * Math.PI * radius * radius), 0.003);
    assertTrue(rmsNormalErrorDegrees(surface, 24) < 1, "normals off by " + said());
  }

  @Test
  void normalsOfASphereOfBitsDeviateByLessThanThreeDegreesRms() {
    WeldedSurface surface =
        Shapes.surface(SurfaceSource.ofBits(Shapes.sphere(64, 25), Shapes.UNIT));
    double error = rmsNormalErrorDegrees(surface, 32);
    assertTrue(error < 3, "rms error, degrees: " + error);
  }

  @Test
  void bricksOfEverySizeGiveTheSameSurface() {
    BitCube bits = Shapes.random(17, 19, 13, 0.4, random);
    SurfaceSource source = SurfaceSource.ofBits(bits, new Vec3(0.977, 0.977, 1.4));
    Set<List<Float>> expected = triangles(Shapes.bricks(source, 40));
    for (int edge : new int[] {5, 8, 17}) {
      assertEquals(expected, triangles(Shapes.bricks(source, edge)), "brick edge " + edge + said());
      assertClosed(WeldedSurface.of(Shapes.bricks(source, edge)));
    }
  }

  @Test
  void aVertexOnABrickBorderHasTheSameBitsAndNormalInEveryBrick() {
    BitCube bits = Shapes.random(30, 20, 20, 0.5, random);
    SurfaceSource source = SurfaceSource.ofBits(bits, new Vec3(0.7, 0.7, 3));
    Map<Long, List<Number>> seen = new HashMap<>();
    int shared = 0;
    for (SurfaceBrick brick : Shapes.bricks(source, 8)) {
      for (int v = 0; v < brick.vertexCount(); v++) {
        List<Number> now = vertex(brick, v);
        List<Number> before = seen.put(brick.cells()[v], now);
        if (before != null) {
          shared++;
          assertEquals(before, now, said());
        }
      }
    }
    assertTrue(shared > 1000, "too few shared vertices to say anything: " + shared);
  }

  @Test
  void theSidesOfAThinWallDoNotMeet() {
    BitCube bits = Shapes.cube(30, 30, 30, (x, y, z) -> Math.floor(x + 0.4 * y) == 20);
    WeldedSurface surface = Shapes.surface(SurfaceSource.ofBits(bits, Shapes.UNIT));
    assertClosed(surface);
    assertTrue(
        SurfaceMeasures.of(surface).volumeMm3() > 0.5 * bits.solidCount(),
        "volume " + SurfaceMeasures.of(surface).volumeMm3());
  }

  @Test
  void emptyBricksAndBricksInsideASolidHaveNoTriangles() {
    BitCube empty = new BitCube(90, 90, 90);
    SurfaceExtractor extractor = new SurfaceExtractor();
    SurfaceSource source = SurfaceSource.ofBits(empty, Shapes.UNIT);
    assertNull(extractor.extract(source, AmbientOcclusion.NONE, 0));
    BitCube full = Shapes.cube(130, 130, 130, (x, y, z) -> true);
    SurfaceSource solid = SurfaceSource.ofBits(full, Shapes.UNIT);
    BrickLayout layout = extractor.layout(solid);
    assertNull(extractor.extract(solid, AmbientOcclusion.NONE, layout.brick(1, 1, 1)));
  }

  private String said() {
    return " (-Dpalpate.seed=" + seed + ")";
  }

  private static double distance(int i, int j, int k, double middle) {
    return Math.sqrt(
        Shapes.square(i + 0.5 - middle)
            + Shapes.square(j + 0.5 - middle)
            + Shapes.square(k + 0.5 - middle));
  }

  private static double rmsNormalErrorDegrees(WeldedSurface surface, double middle) {
    double sum = 0;
    for (int v = 0; v < surface.vertexCount(); v++) {
      double along = 0;
      double radius = 0;
      double length = 0;
      for (int axis = 0; axis < 3; axis++) {
        double out = surface.positionsMm()[3 * v + axis] - middle;
        double normal = surface.normals()[4 * v + axis];
        along += out * normal;
        radius += out * out;
        length += normal * normal;
      }
      double cosine = along / Math.sqrt(radius * length);
      sum += Shapes.square(Math.toDegrees(Math.acos(Math.min(1, cosine))));
    }
    return Math.sqrt(sum / surface.vertexCount());
  }

  private static boolean hasEdgeContact(BitCube bits) {
    for (int cell = 0; cell < 125; cell++) {
      int i = cell % 5 - 1;
      int j = cell / 5 % 5 - 1;
      int k = cell / 25 - 1;
      for (int axis = 0; axis < 3; axis++) {
        int[] u = {axis == 2 ? 1 : 0, axis == 0 ? 1 : 0, axis == 1 ? 1 : 0};
        int[] v = {axis == 1 ? 1 : 0, axis == 2 ? 1 : 0, axis == 0 ? 1 : 0};
        boolean a = bits.get(i, j, k);
        boolean b = bits.get(i + u[0], j + u[1], k + u[2]);
        boolean c = bits.get(i + v[0], j + v[1], k + v[2]);
        boolean d = bits.get(i + u[0] + v[0], j + u[1] + v[1], k + u[2] + v[2]);
        if (a == d && b == c && a != b) {
          return true;
        }
      }
    }
    return false;
  }

  /** Counts the uses of each edge in its two directions. */
  private static Map<Long, int[]> edges(WeldedSurface surface) {
    Map<Long, int[]> edges = new HashMap<>();
    int[] t = surface.triangles();
    for (int i = 0; i < t.length; i++) {
      int from = t[i];
      int to = t[i % 3 == 2 ? i - 2 : i + 1];
      long key = ((long) Math.min(from, to) << 32) | Math.max(from, to);
      edges.computeIfAbsent(key, k -> new int[2])[from < to ? 0 : 1]++;
    }
    return edges;
  }

  private void assertClosed(WeldedSurface surface) {
    edges(surface).values().forEach(count -> assertEquals(count[0], count[1], said()));
  }

  private static int components(WeldedSurface surface) {
    int[] root = new int[surface.vertexCount()];
    Arrays.setAll(root, v -> v);
    int[] t = surface.triangles();
    for (int i = 0; i < t.length; i += 3) {
      root[find(root, t[i])] = find(root, t[i + 1]);
      root[find(root, t[i + 1])] = find(root, t[i + 2]);
    }
    Set<Integer> roots = new HashSet<>();
    for (int v = 0; v < root.length; v++) {
      roots.add(find(root, v));
    }
    return roots.size();
  }

  private static int find(int[] root, int vertex) {
    int at = vertex;
    while (root[at] != at) {
      at = root[at];
    }
    return at;
  }

  private static Set<List<Float>> triangles(List<SurfaceBrick> bricks) {
    Set<List<Float>> all = new HashSet<>();
    for (SurfaceBrick brick : bricks) {
      float[] p = brick.positionsMm();
      int[] t = brick.triangles();
      for (int i = 0; i < t.length; i += 3) {
        int a = 3 * t[i];
        int b = 3 * t[i + 1];
        int c = 3 * t[i + 2];
        all.add(
            List.of(p[a], p[a + 1], p[a + 2], p[b], p[b + 1], p[b + 2], p[c], p[c + 1], p[c + 2]));
      }
    }
    return all;
  }

  private static List<Number> vertex(SurfaceBrick brick, int v) {
    return List.of(
        brick.positionsMm()[3 * v],
        brick.positionsMm()[3 * v + 1],
        brick.positionsMm()[3 * v + 2],
        brick.normals()[4 * v],
        brick.normals()[4 * v + 1],
        brick.normals()[4 * v + 2]);
  }

  /** Sums solid angles by the formula of van Oosterom and Strackee (1983), over 4 pi. */
  private static double windingNumber(WeldedSurface s, double x, double y, double z) {
    SurfaceMeasures corners = SurfaceMeasures.of(s);
    double sum = 0;
    for (int t = 0; t < s.triangles().length; t += 3) {
      double[][] r = new double[3][];
      for (int c = 0; c < 3; c++) {
        r[c] = new double[] {corners.x(t + c) - x, corners.y(t + c) - y, corners.z(t + c) - z};
      }
      double la = Math.sqrt(dot(r[0], r[0]));
      double lb = Math.sqrt(dot(r[1], r[1]));
      double lc = Math.sqrt(dot(r[2], r[2]));
      double volume =
          r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1])
              + r[0][1] * (r[1][2] * r[2][0] - r[1][0] * r[2][2])
              + r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
      double below =
          la * lb * lc + dot(r[0], r[1]) * lc + dot(r[1], r[2]) * la + dot(r[2], r[0]) * lb;
      sum += 2 * Math.atan2(volume, below);
    }
    return sum / (4 * Math.PI);
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
}
