package org.palpate.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class CameraAxesTest {

  @Test
  void theRightOfAPictureFromTheFrontIsThePatientsLeft() {
    SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
    model.look(StandardView.FRONT, 1);
    RigidTransform front = model.camera().axes(WorldAxes.RAS);
    assertDirection(-1, 0, 0, front.axisX());
    assertDirection(0, 0, 1, front.axisY());
    assertDirection(0, 1, 0, front.axisZ());
    assertDirection(1, 0, 0, model.camera().axes(WorldAxes.LPS).axisX());
  }

  @Test
  void theAxesOfATurnedViewAreARotation() {
    SceneModel model = new SceneModel(WorldAxes.RAS, Theme.DARK);
    for (int i = 0; i < 100; i++) {
      model.moveCamera(camera -> camera.orbit(0.7, 0.31), false);
      RigidTransform axes = model.camera().axes(WorldAxes.RAS);
      assertTrue(axes.isOrthonormal() && !axes.isMirrored(), "i=" + i);
    }
    assertTrue(model.camera().axes(WorldAxes.LAS).isMirrored());
  }

  private static void assertDirection(double x, double y, double z, Vec3 axis) {
    assertEquals(0, axis.sub(new Vec3(x, y, z), new Vec3()).length(), 1e-12, axis.toString());
  }
}
