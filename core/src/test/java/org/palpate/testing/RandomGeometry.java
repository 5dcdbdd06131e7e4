package org.palpate.testing;

import java.util.SplittableRandom;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/** Random vectors and poses. */
public final class RandomGeometry {
  private RandomGeometry() {}

  /** Returns a random vector in the cube from -size to size. */
  public static Vec3 vector(SplittableRandom random, double size) {
    return new Vec3(
        random.nextDouble(-size, size),
        random.nextDouble(-size, size),
        random.nextDouble(-size, size));
  }

  /** Returns a random unit vector; all directions are equally likely. */
  public static Vec3 direction(SplittableRandom random) {
    Vec3 v;
    do {
      v = vector(random, 1);
    } while (!(v.length() <= 1 && v.length() > 0));
    return v.mul(1 / v.length(), v);
  }

  /** Returns a pose with a random rotation and a translation in the cube from -size to size, mm. */
  public static Pose pose(SplittableRandom random, double size) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(vector(random, 3));
    pose.translation.set(vector(random, size));
    return pose;
  }
}
