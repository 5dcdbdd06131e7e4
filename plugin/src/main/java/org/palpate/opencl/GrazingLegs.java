package org.palpate.opencl;

import java.util.SplittableRandom;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * Points and motions whose legs graze the corners, edges and faces of voxels to within rounding. A
 * verdict on such a leg depends on every bit of its ends and on the error bound of the test. Each
 * point grazes in one of the motions, and has an ordinary leg in the others.
 */
final class GrazingLegs extends PointArrays {
  /** The number of motions. */
  static final int MOTIONS = 4;

  private static final double LONGEST_VOXELS = 2;

  private final SplittableRandom random;
  private final int size;
  private final AffineMap[] from = new AffineMap[MOTIONS];
  private final AffineMap[] to = new AffineMap[MOTIONS];

  /**
   * Makes points and motions.
   *
   * @param size the number of voxels along each axis of the grid that is grazed
   */
  GrazingLegs(SplittableRandom random, int size, int count) {
    super(count);
    this.random = random;
    this.size = size;
    for (int motion = 0; motion < MOTIONS; motion++) {
      makeMotion(motion);
    }
  }

  /**
   * Makes one motion and its points. Every second one also turns between world and grid, and every
   * fourth lies far from the origin of the world.
   */
  private void makeMotion(int motion) {
    Pose pose = new Pose();
    if (motion % 2 == 1) {
      pose.rotation.setRotationVector(vector(2));
      pose.translation.set(vector(motion % 4 == 1 ? size : 0));
    }
    from[motion] = new AffineMap().set(pose);
    AffineMap inverse = new AffineMap().setInverse(pose);
    Vec3 displacement = displacement();
    to[motion] = new AffineMap().set(from[motion]);
    to[motion].offsetX += displacement.x;
    to[motion].offsetY += displacement.y;
    to[motion].offsetZ += displacement.z;
    for (int n = motion; n < x.length; n += MOTIONS) {
      Vec3 start = inverse.transform(grazingStart(displacement), new Vec3());
      x[n] = disturbed(start.x);
      y[n] = disturbed(start.y);
      z[n] = disturbed(start.z);
    }
  }

  /**
   * Returns the displacement of all points in a motion, voxels: any one, a short one, or one within
   * a grid plane.
   */
  private Vec3 displacement() {
    Vec3 displacement = vector(LONGEST_VOXELS);
    switch (random.nextInt(5)) {
      case 0 -> displacement.set(random.nextInt(3), 0);
      case 1 -> displacement.mul(0x1p-30, displacement);
      case 2 ->
          displacement.set(
              Math.rint(2 * displacement.x) / 2,
              Math.rint(2 * displacement.y) / 2,
              Math.rint(displacement.z));
      default -> {}
    }
    return displacement;
  }

  /**
   * Returns a start from which the displacement leads through a corner, an edge or a face. Most of
   * these lie at the origin of the grid, where coordinates have the most digits: only there does
   * the rounding of products decide.
   */
  private Vec3 grazingStart(Vec3 displacement) {
    Vec3 start = new Vec3();
    double part = random.nextDouble();
    int free = random.nextInt(6);
    int reach = random.nextInt(3) == 0 ? size : 1;
    for (int axis = 0; axis < 3; axis++) {
      double corner = random.nextInt(reach + 1);
      boolean isFree = axis == free || (free == 5 && axis > 0);
      start.set(axis, corner + (isFree ? random.nextDouble() : 0) - part * displacement.get(axis));
    }
    return start;
  }

  private double disturbed(double value) {
    return switch (random.nextInt(8)) {
      case 0 -> Math.nextUp(value);
      case 1 -> Math.nextDown(value);
      case 2 -> Math.rint(value);
      default -> value;
    };
  }

  private Vec3 vector(double reach) {
    return new Vec3(component(reach), component(reach), component(reach));
  }

  private double component(double reach) {
    return reach * random.nextDouble(-1, 1);
  }

  /** Returns the map at the start of a motion; not to be written. */
  AffineMap from(int motion) {
    return from[motion];
  }

  /** Returns the map at the end of a motion; not to be written. */
  AffineMap to(int motion) {
    return to[motion];
  }
}
