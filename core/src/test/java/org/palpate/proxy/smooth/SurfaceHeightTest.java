package org.palpate.proxy.smooth;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.field.OccupancyField;
import org.palpate.proxy.smooth.field.SeedCell;
import org.palpate.testing.Floor;
import org.palpate.volume.BitCube;

class SurfaceHeightTest {
  private OccupancyField field;
  private SurfaceHeight height;
  private final SeedCell seed = new SeedCell();

  private void use(double edgeMm, BitCube bits) {
    GridMetric metric = new GridMetric(edgeMm, edgeMm, edgeMm);
    field = OccupancyField.ofBits(metric);
    field.use(new CollisionScene(List.of(bits)));
    height = new SurfaceHeight(field, new EdgeUnits(metric));
  }

  private void stand(double x, double y, double z) {
    Vec3 at = new Vec3(x, y, z);
    field.evaluate(seed.set(at), at);
  }

  /** The kernel is no Gaussian, so that the height is true to some hundredths of a voxel. */
  @ParameterizedTest
  @ValueSource(doubles = {1, 0.5})
  void overAFlatFloorItIsTheDistanceToTheVoxels(double edgeMm) {
    use(edgeMm, Floor.bits());
    for (double above : new double[] {0.6, 0.9, 1.2, 1.5}) {
      stand(16.3, 15.6, Floor.TOP + above);
      assertEquals(above * edgeMm, height.onSurfaceMm(0), 0.06 * edgeMm);
      assertEquals(above * edgeMm, height.onSurfaceMm(100), 0.06 * edgeMm);
    }
    stand(16.3, 15.6, 28);
    double most = height.onSurfaceMm(100);
    double offset = field.level().mostOffsetEdges();
    assertTrue(most > offset * edgeMm && most < 3 * edgeMm, "bounded far above: " + most);
  }

  @Test
  void overABallItIsTheDistanceToTheBallOnceThePathIsLong() {
    int edge = 40;
    for (double radius : new double[] {8, 12}) {
      BitCube ball = new BitCube(edge, edge, edge);
      for (int n = 0; n < edge * edge * edge; n++) {
        double x = n % edge + 0.5 - 20;
        double y = n / edge % edge + 0.5 - 20;
        int k = n / (edge * edge);
        double z = k + 0.5 - 20;
        if (x * x + y * y + z * z < radius * radius) {
          ball.set(n % edge, n / edge % edge, n / (edge * edge));
        }
      }
      use(1, ball);
      double sum = 0;
      int count = 0;
      for (int n = 0; n < 400; n++) {
        double a = 0.05 * n;
        double b = 0.003 * n - 0.6;
        double r = radius + 0.9;
        stand(
            20 + r * Math.cos(a) * Math.cos(b),
            20 + r * Math.sin(a) * Math.cos(b),
            20 + r * Math.sin(b));
        double mm = height.onSurfaceMm(0.5);
        if (n >= 100) {
          sum += mm;
          count++;
        }
        assertEquals(0.9, mm, 0.3, "ripple of the voxels");
      }
      assertEquals(0.9, sum / count, 0.08, "radius " + radius);
    }
  }

  /** Curvature is smoothed over 12 voxels of path, and never differs by more than the ripple. */
  @Test
  void aChangeOfCurvatureCountsByThePathExceptForTheRipple() {
    Quadrics quadric = new Quadrics(new GridMetric(1, 1, 1), new Vec3(16, 6, 6), false);
    use(1, quadric.bits());
    Vec3 at = quadric.position(new SplittableRandom(3), 1);
    stand(at.x, at.y, at.z);
    double first = height.onSurfaceMm(0);
    double soon = height.onSurfaceMm(0.6);
    double all = height.onSurfaceMm(12);
    assertEquals(0.05, first - all, 1e-12, "it began with the ripple, and ends without it");
    assertEquals(0.05 * (first - all), first - soon, 1e-12, "0.6 of 12 voxels");
  }

  @Test
  void wherePointsStandOnVoxelsItFallsToZeroWithTheOccupancy() {
    use(0.5, Floor.bits());
    stand(16.3, 15.6, Floor.TOP + 0.5);
    double low = height.onVoxelsMm(100);
    assertTrue(low > 0.2 && low <= 0.5 * field.level().mostOffsetEdges(), "near the floor " + low);
    BitCube single = new BitCube(32, 32, 32);
    single.set(16, 16, 16);
    use(0.5, single);
    stand(16.5, 16.5, 17.1);
    assertEquals(0, height.onVoxelsMm(100), 1e-9);
    stand(16.5, 16.5, 30);
    assertEquals(0, height.onVoxelsMm(100));
  }
}
