package org.palpate.fracture;

import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.fracture.PosedBits;

/**
 * The motion of a fragment between two situations, both relative to a reference fragment.
 *
 * @param distanceMm displacement of the fragment's centroid
 * @param angleDegrees angle of its rotation
 */
public record Residual(double distanceMm, double angleDegrees) {

  /**
   * {@return the motion that leads from rest, the truth of a synthetic fracture, to the poses}
   *
   * @param fragment the fragment where it stands
   * @param reference the pose of the reference fragment
   */
  public static Residual fromRest(PosedBits fragment, Pose reference) {
    Vec3 centroid = centroid(fragment);
    Vec3 present = fragment.pose().transform(centroid, new Vec3());
    reference.inverseTransform(present, present);
    Pose relative = new Pose();
    reference.rotation.conjugate(relative.rotation);
    relative.rotation.multiply(fragment.pose().rotation, relative.rotation);
    return new Residual(
        present.sub(centroid, present).length(), Math.toDegrees(relative.rotation.angle()));
  }

  /**
   * {@return the motion that led from an earlier pose of a fragment to its present one}
   *
   * @param earlier its earlier pose, from rest, world mm
   * @param fragment the fragment where it stands
   */
  public static Residual since(Pose earlier, PosedBits fragment) {
    Vec3 centroid = centroid(fragment);
    Vec3 before = earlier.transform(centroid, new Vec3());
    Vec3 now = fragment.pose().transform(centroid, centroid);
    Quaternion turn = earlier.rotation.conjugate(new Quaternion());
    fragment.pose().rotation.multiply(turn, turn);
    return new Residual(now.sub(before, now).length(), Math.toDegrees(turn.angle()));
  }

  /**
   * {@return the mean of the voxel centres at rest, world mm}
   *
   * @param fragment a fragment with a solid voxel
   */
  public static Vec3 centroid(PosedBits fragment) {
    BitCube bits = fragment.bits();
    IntBox box = bits.bounds();
    Vec3 sum = new Vec3();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          if (bits.get(i, j, k)) {
            sum.set(sum.x + i + 0.5, sum.y + j + 0.5, sum.z + k + 0.5);
          }
        }
      }
    }
    sum.mul(1.0 / bits.solidCount(), sum);
    return fragment.grid().gridToWorld(sum, sum);
  }
}
