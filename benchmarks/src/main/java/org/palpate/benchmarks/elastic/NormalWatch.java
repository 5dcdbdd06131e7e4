package org.palpate.benchmarks.elastic;

import org.palpate.elastic.ElasticBodyVariants;
import org.palpate.geometry.Vec3;

/**
 * Compares the force with the normal of the deformed upper face of a block, in a grid of voxels of
 * 1 mm. The normal is the cross product of two differences of the deformation over 4 mm around the
 * point. One thread.
 */
final class NormalWatch {
  private static final double HALF_MM = 2;

  private final ElasticSession session;
  private final Vec3 material = new Vec3();
  private final Vec3 high = new Vec3();
  private final Vec3 low = new Vec3();
  private final Vec3[] tangents = {new Vec3(), new Vec3()};
  private final Vec3 normal = new Vec3();
  private double sum;
  private long frames;

  NormalWatch(ElasticSession session) {
    this.session = session;
  }

  /** Takes the last frame into account, if there was a force. */
  void look() {
    Vec3 force = session.forceNewton();
    double newton = force.length();
    if (newton == 0) {
      return;
    }
    for (int axis = 0; axis < 2; axis++) {
      beside(axis, HALF_MM, high);
      beside(axis, -HALF_MM, low);
      high.sub(low, tangents[axis]);
    }
    tangents[0].cross(tangents[1], normal);
    double cosine = normal.dot(force) / (normal.length() * newton);
    double degrees = Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, cosine))));
    sum += degrees * degrees;
    frames++;
  }

  private void beside(int axis, double mm, Vec3 dest) {
    material.set(session.point().position);
    material.set(axis, material.get(axis) + mm);
    ElasticBodyVariants.present(session.body(), material, dest);
  }

  double rmsDegrees() {
    return Math.sqrt(sum / frames);
  }
}
