package org.palpate.rigid.tool;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

class TriangleMeshTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  @Test
  void aBoxHasTheVolumeAreaAndMomentsOfABox() {
    TriangleMesh box = TestMeshes.box(2, 3, 5);
    MassProperties mass = box.massProperties();
    assertTrue(box.isClosed());
    assertEquals(62, box.areaMm2(), 1e-12);
    assertEquals(30, mass.volumeMm3(), 1e-12);
    assertEquals(0, mass.centroidMm().sub(new Vec3(1, 1.5, 2.5), new Vec3()).length(), 1e-12);
    MassProperties shape = new BoxShape(2, 3, 5).massProperties();
    assertEquals(shape.metric().rmsRadiusMm(), mass.metric().rmsRadiusMm(), 1e-12);
  }

  @Test
  void aBallOfManyTrianglesIsAlmostARoundBall() {
    TriangleMesh ball = TestMeshes.ball(4, new Vec3(10, -20, 30), 5);
    MassProperties mass = ball.massProperties();
    assertTrue(ball.isClosed());
    assertEquals(1, mass.volumeMm3() / (4.0 / 3 * Math.PI * 64), 0.003);
    assertEquals(0, mass.centroidMm().sub(new Vec3(10, -20, 30), new Vec3()).length(), 1e-9);
    assertEquals(Math.sqrt(0.6) * 4, mass.metric().rmsRadiusMm(), 0.01);
  }

  @Test
  void trianglesOfRandomDirectionsAreTurnedOutward() {
    int[] corners = TestMeshes.boxCorners();
    for (int round = 0; round < 50; round++) {
      int[] mixed = corners.clone();
      for (int n = 0; n < mixed.length; n += 3) {
        if (random.nextBoolean()) {
          mixed[n] = corners[n + 1];
          mixed[n + 1] = corners[n];
        }
      }
      TriangleMesh mesh = new TriangleMesh(TestMeshes.boxCoordinates(1, 2, 3), mixed);
      assertTrue(mesh.isClosed());
      assertEquals(6, mesh.massProperties().volumeMm3(), 1e-12);
    }
  }

  @Test
  void aMeshThatFacesInwardIsTurnedAndOneWithAHoleIsOpen() {
    int[] corners = TestMeshes.boxCorners();
    int[] inward = corners.clone();
    for (int n = 0; n < inward.length; n += 3) {
      inward[n] = corners[n + 1];
      inward[n + 1] = corners[n];
    }
    double[] coordinates = TestMeshes.boxCoordinates(1, 2, 3);
    assertEquals(6, new TriangleMesh(coordinates, inward).massProperties().volumeMm3(), 1e-12);
    TriangleMesh open = new TriangleMesh(coordinates, Arrays.copyOf(corners, 30));
    assertFalse(open.isClosed());
    assertEquals(open.areaMm2(), open.massProperties().volumeMm3(), 1e-12);
  }

  @Test
  void theCentroidOfAnOpenMeshIsThatOfItsArea() {
    double[] coordinates = {0, 0, 0, 3, 0, 0, 0, 3, 0, 3, 3, 6};
    TriangleMesh mesh = new TriangleMesh(coordinates, new int[] {0, 1, 2});
    Vec3 centroid = mesh.massProperties().centroidMm();
    assertEquals(0, centroid.sub(new Vec3(1, 1, 0), new Vec3()).length(), 1e-12);
  }

  @Test
  void trianglesWithoutAnAreaAreLeftOut() {
    double[] coordinates = TestMeshes.boxCoordinates(1, 2, 3);
    int[] corners = Arrays.copyOf(TestMeshes.boxCorners(), 39);
    corners[36] = 1;
    corners[37] = 1;
    corners[38] = 4;
    assertTrue(new TriangleMesh(coordinates, corners).isClosed());
    assertThrows(
        IllegalArgumentException.class, () -> new TriangleMesh(coordinates, new int[] {1, 1, 4}));
  }
}
