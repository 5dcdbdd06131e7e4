package org.palpate.scene.gl;

import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneState;

/** Converts a position in the picture of an eye and its depth to a point of the scene. */
final class Unprojection {
  private Unprojection() {}

  /**
   * Writes the point that the picture shows at a position into {@code dest}.
   *
   * @param eye 0 for a single eye, -1 for the left and 1 for the right of two
   * @param x -1 at the left edge, 1 at the right edge
   * @param y -1 at the lower edge, 1 at the upper edge
   * @param depth value of the depth buffer, 0 to 1
   */
  static Vec3 toScene(
      SceneState state, int eye, double aspect, double x, double y, double depth, Vec3 dest) {
    Camera camera = state.camera();
    Matrix4 p = camera.perspective(eye, aspect, state.middle(), state.radiusMm());
    // z of clip over w is (p22 z + p23) / -z, so z in the camera's frame follows.
    double distanceMm = p.at(2, 3) / (2 * depth - 1 + p.at(2, 2));
    double half = Camera.HEIGHT_PER_DISTANCE / 2 * distanceMm;
    double right = (x + p.at(0, 2)) * half * aspect;
    double up = y * half;
    Vec3 from = camera.eye(eye);
    return dest.set(
        from.x + camera.right().x * right + camera.up().x * up - camera.back().x * distanceMm,
        from.y + camera.right().y * right + camera.up().y * up - camera.back().y * distanceMm,
        from.z + camera.right().z * right + camera.up().z * up - camera.back().z * distanceMm);
  }
}
