package org.palpate.benchmarks.input;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/** Where a device is, frame after frame, in grid coordinates. Not changed once made. */
public final class Trajectory {
  private final String name;
  private final double[] xyz;

  /**
   * A trajectory that keeps the array.
   *
   * @param name what the hand does
   * @param xyz three doubles a frame
   */
  public Trajectory(String name, double[] xyz) {
    this.name = name;
    this.xyz = xyz;
  }

  public String name() {
    return name;
  }

  public int frames() {
    return xyz.length / 3;
  }

  /** Writes where the device is in a frame into {@code dest}. */
  public Vec3 at(int frame, Vec3 dest) {
    return dest.set(xyz[3 * frame], xyz[3 * frame + 1], xyz[3 * frame + 2]);
  }

  /** Whether both are the same to the bit. */
  public boolean sameBits(Trajectory other) {
    return Arrays.equals(xyz, other.xyz);
  }
}
