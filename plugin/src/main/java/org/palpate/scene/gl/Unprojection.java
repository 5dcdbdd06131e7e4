package org.palpate.scene.gl;

import org.palpate.geometry.Vec3;
import org.palpate.scene.Camera;
import org.palpate.scene.Matrix4;
import org.palpate.scene.SceneState;

/** Converts a position in the picture and its depth to a point of the scene. */
final class Unprojection {
  private Unprojection() {}

  /**
   * Writes the point that the picture shows at a position into {@code dest}.
   *
   * @param x -1 at the left edge, 1 at the right edge
   * @param y -1 at the lower edge, 1 at the upper edge
   * @param depth value of the depth buffer, 0 to 1
   */
  static Vec3 toScene(
      SceneState state, double aspect, double x, double y, double depth, Vec3 dest) {
    Camera camera = state.camera();
    Matrix4 p = camera.perspective(0, aspect, state.middle(), state.radiusMm());
    // z of clip over w is (p22 z + p23) / -z, so z in the camera's frame follows.
    double z = p.at(2, 3) / -(2 * depth - 1 + p.at(2, 2));
    return toScene(camera, aspect, x, y, -z, dest);
  }

  /**
   * Writes the point at a position of the picture and a distance along the line of sight into
   * {@code dest}.
   */
  static Vec3 toScene(
      Camera camera, double aspect, double x, double y, double distanceMm, Vec3 dest) {
    double half = Camera.HEIGHT_PER_DISTANCE / 2 * distanceMm;
    Vec3 eye = camera.eye();
    double right = x * half * aspect;
    double up = y * half;
    return dest.set(
        eye.x + camera.right().x * right + camera.up().x * up - camera.back().x * distanceMm,
        eye.y + camera.right().y * right + camera.up().y * up - camera.back().y * distanceMm,
        eye.z + camera.right().z * right + camera.up().z * up - camera.back().z * distanceMm);
  }
}
