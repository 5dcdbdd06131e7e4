package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class ToolSamplerTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  static Stream<ToolShape> shapes() {
    return Stream.of(
        RodShape.sphere(4),
        RodShape.sphere(0.4),
        RodShape.capsule(2, 9),
        RodShape.cylinder(3, 5),
        RodShape.cylinder(0.3, 20),
        RodShape.needle(1.5, 30),
        new BoxShape(3, 8, 1.3),
        new BoxShape(20, 0.2, 5));
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void everySurfacePointLiesNearASample(ToolShape shape) {
    double cover = 0.7;
    RigidTool tool = ToolSampler.ofShape(shape, cover);
    assertEquals(cover, tool.coverRadiusMm());
    Vec3 reference = tool.referenceMm(new Vec3());
    for (int n = 0; n < 3000; n++) {
      Vec3 p = surfacePoint(shape).sub(reference, new Vec3());
      assertTrue(nearest(tool, p) <= cover + 1e-9, shape + " at " + p);
    }
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void everySampleLiesOnTheSurface(ToolShape shape) {
    RigidTool tool = ToolSampler.ofShape(shape, 0.5);
    Vec3 reference = tool.referenceMm(new Vec3());
    for (int n = 0; n < tool.count(); n++) {
      Vec3 p = tool.point(n, new Vec3()).add(reference, new Vec3());
      assertTrue(touches(shape, p), shape + " at " + p);
    }
  }

  /** Whether some but not all points very near to p are in the shape. */
  private static boolean touches(ToolShape shape, Vec3 p) {
    int inside = 0;
    for (int n = 0; n < 27; n++) {
      double e = 1e-7;
      boolean holds =
          shape.contains(p.x + e * (n % 3 - 1), p.y + e * (n / 3 % 3 - 1), p.z + e * (n / 9 - 1));
      inside += holds ? 1 : 0;
    }
    return inside > 0 && inside < 27;
  }

  /** Finds a surface point between a random point inside and one outside, by halving. */
  private Vec3 surfacePoint(ToolShape shape) {
    Vec3 low = shape.low();
    Vec3 size = shape.high().sub(low, new Vec3());
    Vec3 inside = new Vec3();
    do {
      inside.set(
          low.x + random.nextDouble() * size.x,
          low.y + random.nextDouble() * size.y,
          low.z + random.nextDouble() * size.z);
    } while (!shape.contains(inside.x, inside.y, inside.z));
    double azimuth = random.nextDouble(2 * Math.PI);
    double height = random.nextDouble(-1, 1);
    double flat = Math.sqrt(1 - height * height);
    Vec3 direction = new Vec3(flat * Math.cos(azimuth), flat * Math.sin(azimuth), height);
    double near = 0;
    double far = 2 * size.length();
    for (int n = 0; n < 60; n++) {
      double middle = (near + far) / 2;
      Vec3 p = direction.mul(middle, new Vec3()).add(inside, new Vec3());
      if (shape.contains(p.x, p.y, p.z)) {
        near = middle;
      } else {
        far = middle;
      }
    }
    return direction.mul(near, direction).add(inside, direction);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void noSurfacePointLiesLowerThanTheLowestAroundTheSamples(ToolShape shape) {
    RigidTool tool = ToolSampler.ofShape(shape, 0.7);
    Vec3 reference = tool.referenceMm(new Vec3());
    Vec3 p = new Vec3();
    for (int direction = 0; direction < 20; direction++) {
      Vec3 up = surfacePoint(RodShape.sphere(1));
      double lowest = Double.POSITIVE_INFINITY;
      for (int n = 0; n < tool.count(); n++) {
        double ofSample = tool.point(n, p).dot(up);
        double around = tool.lowestNear(n, up, p).dot(up);
        assertTrue(around <= ofSample + 1e-9, shape + " along " + up);
        assertTrue(touches(shape, p.add(reference, p)), shape + " at " + p);
        lowest = Math.min(lowest, around);
      }
      // Along the axis of a rod, circles of its side count as the samples on them.
      double most = Math.hypot(up.x, up.y) < 0.1 ? 0.02 : 1e-6;
      for (int n = 0; n < 500; n++) {
        Vec3 q = surfacePoint(shape).sub(reference, new Vec3());
        assertTrue(q.dot(up) >= lowest - most, shape + " along " + up + " at " + q);
      }
    }
  }

  /** Otherwise a contact in a narrow hole would pass to another wall. */
  @Test
  void theLowestPointOfAThinnedToolIsNearItsSample() {
    double radius = 3;
    RigidTool thin = ToolSampler.ofShape(RodShape.sphere(radius), 0.5).thinned(10);
    Vec3 sample = new Vec3();
    Vec3 lowest = new Vec3();
    int moved = 0;
    for (int n = 0; n < thin.count(); n++) {
      thin.point(n, sample);
      for (int direction = 0; direction < 200; direction++) {
        thin.lowestNear(n, surfacePoint(RodShape.sphere(1)), lowest).sub(sample, lowest);
        assertTrue(lowest.length() < 0.33 * radius, "sample " + n + " moved by " + lowest);
        moved += lowest.length() > 0 ? 1 : 0;
      }
    }
    assertTrue(moved > 0, "no direction leads to a lower point");
  }

  private static double nearest(RigidTool tool, Vec3 p) {
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < tool.count(); n++) {
      least = Math.min(least, tool.point(n, new Vec3()).sub(p, new Vec3()).length());
    }
    return least;
  }

  @Test
  void theReferencePointIsTheCentroid() {
    Vec3 ofSphere = ToolSampler.ofShape(RodShape.sphere(5), 1).referenceMm(new Vec3());
    assertEquals(0, ofSphere.length(), 1e-9);
    // A cylinder of length L with a half sphere at low z.
    double r = 2;
    double length = 3;
    double volumes = r * r * length + 2.0 / 3 * r * r * r;
    double expected = -2.0 / 3 * r * r * r * (length / 2 + 3.0 / 8 * r) / volumes;
    Vec3 ofProbe = ToolSampler.ofShape(RodShape.needle(r, length), 1).referenceMm(new Vec3());
    assertEquals(expected, ofProbe.z, 0.01);
  }

  @Test
  void theRadiusOfGyrationIsThatOfTheSolid() {
    RigidTool sphere = ToolSampler.ofShape(RodShape.sphere(5), 1);
    assertEquals(Math.sqrt(3.0 / 5) * 5, sphere.rmsRadiusMm(), 0.01);
    RigidTool box = ToolSampler.ofShape(new BoxShape(2, 4, 6), 1);
    assertEquals(Math.sqrt((4 + 16 + 36) / 12.0), box.rmsRadiusMm(), 0.01);
  }

  @Test
  void samplesTheRimOfASegmentSoThatItsFacesAreCovered() {
    BitCube bits = randomSegment();
    VoxelGrid grid = obliqueGrid(bits, new Vec3(0.7, 1, 2.9));
    RigidTool tool = ToolSampler.ofSegment(bits, grid);
    Vec3 reference = tool.referenceMm(new Vec3());
    for (int n = 0; n < 2000; n++) {
      Vec3 p = grid.gridToWorld(openFacePoint(bits), new Vec3()).sub(reference, new Vec3());
      assertTrue(nearest(tool, p) <= tool.coverRadiusMm() + 1e-9);
    }
    for (int n = 0; n < tool.count(); n++) {
      assertTrue(tool.solid().contains(tool.x(n), tool.y(n), tool.z(n)));
    }
  }

  @Test
  void theReferenceOfASegmentIsTheMeanOfAllItsVoxels() {
    BitCube bits = randomSegment();
    VoxelGrid grid = obliqueGrid(bits, new Vec3(1, 1, 3));
    Vec3 sum = new Vec3();
    for (int n = 0; n < 1000; n++) {
      if (bits.get(n % 10, n / 10 % 10, n / 100)) {
        int j = n / 10 % 10;
        int k = n / 100;
        Vec3 centre = new Vec3(n % 10 + 0.5, j + 0.5, k + 0.5);
        sum.add(grid.gridToWorld(centre, centre), sum);
      }
    }
    sum.mul(1.0 / bits.solidCount(), sum);
    Vec3 reference = ToolSampler.ofSegment(bits, grid).referenceMm(new Vec3());
    assertEquals(0, sum.sub(reference, sum).length(), 1e-9);
  }

  @Test
  void thinningKeepsTheMatterAndSaysThatTheSurfaceIsNotCovered() {
    RigidTool whole = ToolSampler.ofShape(RodShape.sphere(5), 0.3);
    RigidTool thin = whole.thinned(50);
    assertEquals(50, thin.count());
    assertEquals(RigidTool.NOT_COVERED, thin.coverRadiusMm());
    assertEquals(whole.rmsRadiusMm(), thin.rmsRadiusMm());
    double widest = 0;
    for (int n = 0; n < whole.count(); n++) {
      widest = Math.max(widest, nearest(thin, whole.point(n, new Vec3())));
    }
    assertTrue(widest < 3.2, "no sparser than twice the densest spread: " + widest);
    assertSame(whole, whole.thinned(whole.count()));
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void theMassOfAShapeIsThatOfItsCells(ToolShape shape) {
    Vec3 low = shape.low();
    Vec3 size = shape.high().sub(low, new Vec3());
    MomentSum sum = new MomentSum();
    int cells = 60;
    for (int n = 0; n < cells * cells * cells; n++) {
      double x = low.x + size.x * (n % cells + 0.5) / cells;
      double y = low.y + size.y * (n / cells % cells + 0.5) / cells;
      double z = low.z + size.z * (Math.floorDiv(n, cells * cells) + 0.5) / cells;
      if (shape.contains(x, y, z)) {
        sum.add(x, y, z);
      }
    }
    MassProperties cellwise = sum.massProperties();
    MassProperties exact = shape.massProperties();
    double cell = size.x * size.y * size.z / (cells * cells * cells);
    assertEquals(1, cellwise.volumeMm3() * cell / exact.volumeMm3(), 0.01);
    assertEquals(cellwise.centroidMm().z, exact.centroidMm().z, 0.01 * size.z);
    double radius = exact.metric().rmsRadiusMm();
    assertEquals(1, cellwise.metric().rmsRadiusMm() / radius, 0.005);
  }

  @ParameterizedTest
  @MethodSource("shapes")
  void erosionOfAShapeKeepsExactlyWhatIsDeeper(ToolShape shape) {
    Vec3 low = shape.low();
    Vec3 size = shape.high().sub(low, new Vec3());
    double depth = 0.3 * Math.min(size.x, Math.min(size.y, size.z));
    ToolShape eroded = shape.eroded(depth).orElseThrow();
    for (int n = 0; n < 4000; n++) {
      double x = low.x + random.nextDouble() * size.x;
      double y = low.y + random.nextDouble() * size.y;
      double z = low.z + random.nextDouble() * size.z;
      if (eroded.contains(x, y, z)) {
        assertBallInside(shape, new Vec3(x, y, z), depth - 1e-9);
      } else {
        assertFalse(isBallInside(shape, new Vec3(x, y, z), depth * 1.05), shape.toString());
      }
    }
    assertTrue(shape.eroded(size.length()).isEmpty());
  }

  private void assertBallInside(ToolShape shape, Vec3 centre, double radius) {
    assertTrue(isBallInside(shape, centre, radius), shape + " at " + centre);
  }

  /** Whether many points of a sphere lie in a shape. */
  private boolean isBallInside(ToolShape shape, Vec3 centre, double radius) {
    int points = 3000;
    for (int n = 0; n < points; n++) {
      double z = 1 - (2 * n + 1.0) / points;
      double flat = Math.sqrt(1 - z * z);
      double x = centre.x + radius * flat * Math.cos(2.4 * n);
      double y = centre.y + radius * flat * Math.sin(2.4 * n);
      if (!shape.contains(x, y, centre.z + radius * z)) {
        return false;
      }
    }
    return true;
  }

  @Test
  void erosionOfASegmentKeepsEveryPointThatIsDeeper() {
    BitCube bits = new BitCube(10, 10, 10);
    for (int n = 0; n < 1000; n++) {
      if (Math.hypot(n % 10 - 4.2, Math.hypot(n / 10 % 10 - 4.5, n / 100 - 5)) < 4.4) {
        bits.set(n % 10, n / 10 % 10, n / 100);
      }
    }
    VoxelGrid grid = obliqueGrid(bits, new Vec3(1, 0.8, 2));
    VoxelSolid whole = new VoxelSolid(bits, grid);
    for (double depth : new double[] {0.05, 0.3, 0.8, 1.1, 2}) {
      VoxelSolid fine = whole.refined(depth);
      VoxelSolid eroded = fine.eroded(depth);
      assertTrue(depth < 0.1 || eroded.bits().solidCount() < fine.bits().solidCount());
      RigidTool tool = ToolSampler.ofErodedSegment(bits, grid, depth);
      Vec3 reference = tool.referenceMm(new Vec3());
      for (int n = 0; n < 3000; n++) {
        Vec3 p = new Vec3(random.nextDouble(10), random.nextDouble(10), random.nextDouble(10));
        boolean isDeep = depthOf(bits, grid, p) > depth;
        Vec3 world = grid.gridToWorld(p, p).sub(reference, new Vec3());
        if (isDeep) {
          assertTrue(tool.solid().contains(world.x, world.y, world.z), "depth " + depth);
        }
      }
    }
  }

  /** Returns the distance of a point from the nearest empty voxel, mm. */
  private static double depthOf(BitCube bits, VoxelGrid grid, Vec3 p) {
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n < 12 * 12 * 12; n++) {
      int i = n % 12 - 1;
      int j = n / 12 % 12 - 1;
      int k = n / 144 - 1;
      if (!bits.get(i, j, k)) {
        double x = Math.max(0, Math.max(i - p.x, p.x - i - 1)) * grid.spacingMm().x;
        double y = Math.max(0, Math.max(j - p.y, p.y - j - 1)) * grid.spacingMm().y;
        double z = Math.max(0, Math.max(k - p.z, p.z - k - 1)) * grid.spacingMm().z;
        least = Math.min(least, Math.sqrt(x * x + y * y + z * z));
      }
    }
    return least;
  }

  @Test
  void aToolWithoutMatterIsRejected() {
    BitCube none = new BitCube(3, 3, 3);
    VoxelGrid grid = VoxelGrid.ofUnitVoxels(3, 3, 3);
    assertThrows(IllegalArgumentException.class, () -> ToolSampler.ofSegment(none, grid));
    assertThrows(IllegalArgumentException.class, () -> RodShape.cylinder(2, 0));
    assertThrows(IllegalArgumentException.class, () -> RodShape.sphere(Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new BoxShape(1, -1, 1));
  }

  @Test
  void theSpheresOfTheTreeHoldTheirPoints() {
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(5, 20), 0.4);
    SphereTree tree = tool.tree();
    boolean[] seen = new boolean[tool.count()];
    for (int node = 0; node < tree.nodes(); node++) {
      for (int inner = node; inner < tree.skip(node); inner++) {
        for (int n = tree.first(inner); n >= 0 && n < tree.end(inner); n++) {
          Vec3 p = tool.point(n, new Vec3());
          Vec3 centre = new Vec3(tree.x(node), tree.y(node), tree.z(node));
          assertTrue(p.sub(centre, p).length() <= tree.radius(node));
          seen[n] = true;
        }
      }
      assertFalse(tree.first(node) >= 0 && tree.skip(node) != node + 1);
    }
    for (boolean s : seen) {
      assertTrue(s);
    }
  }

  private BitCube randomSegment() {
    BitCube bits = new BitCube(10, 10, 10);
    for (int n = 0; n < 1000; n++) {
      if (random.nextInt(3) > 0) {
        bits.set(n % 10, n / 10 % 10, n / 100);
      }
    }
    return bits;
  }

  private static VoxelGrid obliqueGrid(BitCube bits, Vec3 spacing) {
    RigidTransform oblique =
        new RigidTransform(
            new Vec3(0.6, 0.8, 0), new Vec3(-0.8, 0.6, 0), new Vec3(0, 0, 1), new Vec3(9, -4, 70));
    return new VoxelGrid(bits.sizeX(), bits.sizeY(), bits.sizeZ(), spacing, oblique);
  }

  private Vec3 openFacePoint(BitCube bits) {
    while (true) {
      int[] cell = {random.nextInt(10), random.nextInt(10), random.nextInt(10)};
      int axis = random.nextInt(3);
      int side = random.nextInt(2);
      int[] beyond = cell.clone();
      beyond[axis] += 2 * side - 1;
      if (bits.get(cell[0], cell[1], cell[2]) && !bits.get(beyond[0], beyond[1], beyond[2])) {
        Vec3 p = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
        p.set(axis, side);
        return p.add(new Vec3(cell[0], cell[1], cell[2]), p);
      }
    }
  }
}
