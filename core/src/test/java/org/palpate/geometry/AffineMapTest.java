package org.palpate.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;

class AffineMapTest {
  private static final double TOLERANCE = 1e-12;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Vec3 point = RandomGeometry.vector(random, 5);
  private final Pose pose = RandomGeometry.pose(random, 5);

  private static void assertNear(Vec3 expected, Vec3 actual) {
    double distance = expected.sub(actual, new Vec3()).length();
    assertEquals(0, distance, TOLERANCE, () -> Seeds.seed() + ": " + expected + " " + actual);
  }

  @Test
  void mapsDirectionsWithoutItsOffset() {
    AffineMap map = new AffineMap().set(new AffineMap().set(pose));
    assertNear(pose.rotation.rotate(point, new Vec3()), map.transformDirection(point, new Vec3()));
  }

  @Test
  void mapsAsTheGridDoesAndBack() {
    RigidTransform grid = pose.transform(RigidTransform.identity());
    AffineMap toWorld = new AffineMap().set(grid);
    Vec3 millimetres = toWorld.transform(point, new Vec3());
    assertNear(grid.transform(point, new Vec3()), millimetres);
    AffineMap toGrid = new AffineMap().setInverseGrid(grid, new Vec3(0.5, 2, 4));
    assertNear(
        new Vec3(point.x / 0.5, point.y / 2, point.z / 4),
        toGrid.transform(millimetres, new Vec3()));
  }

  @Test
  void givesEachComponentByItself() {
    AffineMap map = new AffineMap().set(pose);
    Vec3 image = map.transform(point, new Vec3());
    assertEquals(image.x, map.x(point.x, point.y, point.z));
    assertEquals(image.y, map.y(point.x, point.y, point.z));
    assertEquals(image.z, map.z(point.x, point.y, point.z));
    assertSame(map, map.set(pose));
    assertSame(map, map.setInverse(pose));
  }
}
