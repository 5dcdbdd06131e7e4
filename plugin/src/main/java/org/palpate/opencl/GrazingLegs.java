package org.palpate.opencl;

import java.util.SplittableRandom;
import org.palpate.collision.MotionGroup;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * Points and groups of motions whose legs graze the corners, edges and faces of voxels to within
 * rounding. A verdict on such a leg depends on every bit of its ends and on the error bound of the
 * test. Each motion of a group is half as long as the one before. A point grazes in one motion of
 * one group and in the longer ones, and has ordinary legs in the other groups.
 */
final class GrazingLegs extends PointArrays {
  /** The number of groups. */
  static final int GROUPS = 4;

  private static final double LONGEST_VOXELS = 2;

  private final SplittableRandom random;
  private final int size;
  private final MotionGroup[] groups = new MotionGroup[GROUPS];

  /**
   * Makes points and motions.
   *
   * @param size the number of voxels along each axis of the grid that is grazed
   */
  GrazingLegs(SplittableRandom random, int size, int count) {
    super(count);
    this.random = random;
    this.size = size;
    for (int group = 0; group < GROUPS; group++) {
      makeGroup(group);
    }
  }

  /**
   * Makes one group and its points. Every second one also turns between world and grid, and every
   * fourth lies far from the origin of the world.
   */
  private void makeGroup(int group) {
    Pose pose = new Pose();
    if (group % 2 == 1) {
      pose.rotation.setRotationVector(vector(2));
      pose.translation.set(vector(group % 4 == 1 ? size : 0));
    }
    AffineMap inverse = new AffineMap().setInverse(pose);
    Vec3 displacement = displacement();
    groups[group] = halves(new AffineMap().set(pose), displacement);
    for (int n = group; n < x.length; n += GROUPS) {
      Vec3 whole = displacement.mul(1.0 / (1 << n / GROUPS % MotionGroup.CAPACITY), new Vec3());
      Vec3 start = inverse.transform(grazingStart(whole), new Vec3());
      x[n] = disturbed(start.x);
      y[n] = disturbed(start.y);
      z[n] = disturbed(start.z);
    }
  }

  /** Returns a motion by a displacement, by its half, its quarter and so on. */
  private static MotionGroup halves(AffineMap from, Vec3 displacement) {
    MotionGroup group = new MotionGroup();
    group.begin(from);
    for (int n = 0; n < MotionGroup.CAPACITY; n++) {
      AffineMap to = new AffineMap().set(from);
      to.offsetX += displacement.x / (1 << n);
      to.offsetY += displacement.y / (1 << n);
      to.offsetZ += displacement.z / (1 << n);
      group.add(to);
    }
    return group;
  }

  /**
   * Returns the longest displacement of all points in a group, voxels: any one, a short one, or one
   * within a grid plane.
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

  /** Returns a group; not to be written. */
  MotionGroup group(int number) {
    return groups[number];
  }
}
