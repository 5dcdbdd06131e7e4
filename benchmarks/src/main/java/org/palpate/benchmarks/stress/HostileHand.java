package org.palpate.benchmarks.stress;

import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * A hand that moves to where geometry is weakest: grid planes, edges and corners to the ulp,
 * subnormal steps, 1e12 and up to 1e99 voxels and back, the interaction point itself, the inside of
 * solids. Always finite.
 */
final class HostileHand {
  private static final int MAX_REST_FRAMES = 24;
  private static final double FAR = 1e12;

  private final SplittableRandom random;
  private final BitCube bits;
  private final Vec3 previous = new Vec3();
  private int restFrames;
  private boolean flips;

  HostileHand(SplittableRandom random, BitCube bits) {
    this.random = random;
    this.bits = bits;
  }

  /** Writes the next device position; {@code p} is the position of the interaction point. */
  Vec3 next(Vec3 p, Vec3 device) {
    if (restFrames > 0) {
      restFrames--;
      return flips ? device.mul(-1, device) : device;
    }
    flips = random.nextInt(64) == 0;
    restFrames = random.nextInt(12) == 0 ? random.nextInt(MAX_REST_FRAMES) : 0;
    previous.set(device);
    for (int axis = 0; axis < 3; axis++) {
      device.set(axis, coordinate(axis, p, previous));
    }
    if (random.nextInt(6) == 0) {
      keepInPlane(p, device);
    }
    return device;
  }

  /** Restricts the device to a plane or a line through the point. */
  private void keepInPlane(Vec3 p, Vec3 device) {
    int axis = random.nextInt(3);
    device.set(axis, p.get(axis));
    if (random.nextBoolean()) {
      int other = (axis + 1) % 3;
      device.set(other, p.get(other));
    }
  }

  private double coordinate(int axis, Vec3 p, Vec3 last) {
    int size = axis == 0 ? bits.sizeX() : axis == 1 ? bits.sizeY() : bits.sizeZ();
    double plane = random.nextInt(-2, size + 3);
    return switch (random.nextInt(16)) {
      case 0, 1 -> plane;
      case 2 -> plane + 0.5;
      case 3 -> Math.nextUp(plane);
      case 4 -> Math.nextDown(plane);
      case 5 -> plane + random.nextInt(-3, 4) * 0x1p-20;
      case 6 -> p.get(axis);
      case 7 -> ulps(p.get(axis), random.nextInt(-2, 3));
      case 8 -> p.get(axis) + random.nextInt(-2, 3);
      case 9 -> Math.rint(p.get(axis)) + random.nextInt(-2, 3);
      case 10 -> last.get(axis) + (random.nextDouble() - 0.5) * 0.2;
      case 11 -> random.nextInt(12) == 0 ? extreme() : plane;
      default -> (size + 4) * random.nextDouble() - 2;
    };
  }

  private double extreme() {
    return switch (random.nextInt(8)) {
      case 0 -> -0.0;
      case 1 -> Double.MIN_VALUE;
      case 2 -> -Double.MIN_VALUE;
      case 3 -> 1e-300;
      case 4 -> FAR * random.nextDouble();
      case 5 -> random.nextBoolean() ? -FAR : Math.scalb(1.0, random.nextInt(46, 330));
      case 6 -> 0x1p-60;
      default -> -1e-17;
    };
  }

  private static double ulps(double value, int count) {
    double moved = value;
    for (int n = 0; n < Math.abs(count); n++) {
      moved = count > 0 ? Math.nextUp(moved) : Math.nextDown(moved);
    }
    return moved;
  }
}
