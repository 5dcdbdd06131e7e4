package org.palpate.device;

import java.util.Arrays;
import java.util.BitSet;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * The samples of a device in memory, in order: the content of a trajectory file, or a generated
 * motion.
 *
 * <p>Positions are in world millimetres or in grid coordinates, as the maker of the trajectory
 * states. Nothing is checked, so that a NaN reaches the reader as it would in a live session.
 *
 * <p>One thread fills a trajectory. Any thread may read it afterwards.
 */
public final class Trajectory {
  private static final int INITIAL_CAPACITY = 1024;
  private static final int DOUBLES_PER_POSITION = 3;
  private static final int DOUBLES_PER_QUATERNION = 4;
  private static final double NANOS_PER_MS = 1e6;

  private double[] timesMs;
  private double[] positions;

  /**
   * Null as long as every orientation is the identity. An array of its own keeps the positions
   * dense.
   */
  private double[] quaternions;

  /** The samples at which the device jumped. */
  private final BitSet relocations = new BitSet();

  private int size;

  /** Makes an empty trajectory. */
  public Trajectory() {
    this(new double[INITIAL_CAPACITY], new double[INITIAL_CAPACITY * DOUBLES_PER_POSITION], 0);
  }

  private Trajectory(double[] timesMs, double[] positions, int size) {
    this.timesMs = timesMs;
    this.positions = positions;
    this.size = size;
  }

  /**
   * {@return a trajectory without orientations that keeps the given array}
   *
   * @param xyz three doubles a sample
   * @param periodMs the time between samples, ms; the first sample has time 0
   */
  public static Trajectory ofPositions(double[] xyz, double periodMs) {
    int size = xyz.length / DOUBLES_PER_POSITION;
    double[] timesMs = new double[size];
    Arrays.setAll(timesMs, sample -> sample * periodMs);
    return new Trajectory(timesMs, xyz, size);
  }

  /**
   * Adds a sample without orientation.
   *
   * @param timeMs the time of the sample, ms, from an arbitrary origin
   * @param x the position along x, mm or grid coordinates, as all samples of the trajectory
   * @param y its y component
   * @param z its z component
   */
  public void add(double timeMs, double x, double y, double z) {
    add(timeMs, x, y, z, 1, 0, 0, 0);
  }

  /**
   * Adds a sample with an orientation.
   *
   * @param timeMs the time of the sample, ms, from an arbitrary origin
   * @param x the position along x, mm or grid coordinates, as all samples of the trajectory
   * @param y its y component
   * @param z its z component
   * @param qw the real component of a Hamilton quaternion of norm 1
   * @param qx its first imaginary component
   * @param qy its second
   * @param qz its third
   */
  public void add(
      double timeMs, double x, double y, double z, double qw, double qx, double qy, double qz) {
    if (size == timesMs.length) {
      grow();
    }
    int at = size * DOUBLES_PER_POSITION;
    positions[at] = x;
    positions[at + 1] = y;
    positions[at + 2] = z;
    if (quaternions == null && !isIdentity(qw, qx, qy, qz)) {
      quaternions = identities(timesMs.length);
    }
    if (quaternions != null) {
      putQuaternion(size * DOUBLES_PER_QUATERNION, qw, qx, qy, qz);
    }
    timesMs[size++] = timeMs;
  }

  private void grow() {
    int capacity = Math.max(INITIAL_CAPACITY, 2 * size);
    timesMs = Arrays.copyOf(timesMs, capacity);
    positions = Arrays.copyOf(positions, capacity * DOUBLES_PER_POSITION);
    if (quaternions != null) {
      quaternions = Arrays.copyOf(quaternions, capacity * DOUBLES_PER_QUATERNION);
    }
  }

  /** Whether the quaternion is bit for bit the identity, so that leaving it out loses no sign. */
  private static boolean isIdentity(double qw, double qx, double qy, double qz) {
    return Double.doubleToRawLongBits(qx) == 0
        && Double.doubleToRawLongBits(qy) == 0
        && Double.doubleToRawLongBits(qz) == 0
        && qw == 1;
  }

  private static double[] identities(int capacity) {
    double[] quaternions = new double[capacity * DOUBLES_PER_QUATERNION];
    for (int at = 0; at < quaternions.length; at += DOUBLES_PER_QUATERNION) {
      quaternions[at] = 1;
    }
    return quaternions;
  }

  private void putQuaternion(int at, double qw, double qx, double qy, double qz) {
    quaternions[at] = qw;
    quaternions[at + 1] = qx;
    quaternions[at + 2] = qy;
    quaternions[at + 3] = qz;
  }

  /** Marks the last sample as one at which the device jumped, see {@link DeviceState#relocated}. */
  public void markRelocated() {
    relocations.set(size - 1);
  }

  /** {@return the number of samples} */
  public int size() {
    return size;
  }

  /**
   * {@return the time of a sample as it was given, ms}
   *
   * @param sample the number of the sample, from 0
   */
  public double timeMs(int sample) {
    return timesMs[sample];
  }

  /**
   * {@return the median time between two samples, ms, of those between which time passes; a
   * millisecond if there are none} Allocates.
   */
  public double usualStepMs() {
    double[] steps = new double[Math.max(0, size - 1)];
    int count = 0;
    for (int n = 1; n < size; n++) {
      double step = timesMs[n] - timesMs[n - 1];
      if (step > 0 && step < Double.POSITIVE_INFINITY) {
        steps[count++] = step;
      }
    }
    Arrays.sort(steps, 0, count);
    return count == 0 ? 1 : steps[count / 2];
  }

  /**
   * Writes the position of a sample.
   *
   * @param sample the number of the sample, from 0
   * @param dest receives the position, in the unit of the trajectory
   * @return {@code dest}
   */
  public Vec3 position(int sample, Vec3 dest) {
    int at = sample * DOUBLES_PER_POSITION;
    return dest.set(positions[at], positions[at + 1], positions[at + 2]);
  }

  /**
   * Writes a sample, except for its buttons.
   *
   * @param sample the number of the sample, from 0
   * @param dest receives position, orientation, time and {@link DeviceState#relocated}
   */
  public void read(int sample, DeviceState dest) {
    position(sample, dest.positionMm);
    orientation(sample, dest.orientation);
    dest.timeNanos = Math.round(timesMs[sample] * NANOS_PER_MS);
    dest.relocated = relocations.get(sample);
  }

  /** {@return whether any orientation differs from the identity} */
  public boolean hasOrientations() {
    return quaternions != null;
  }

  /**
   * Writes the orientation of a sample.
   *
   * @param sample the number of the sample, from 0
   * @param dest receives the orientation, the identity in a trajectory without orientations
   * @return {@code dest}
   */
  public Quaternion orientation(int sample, Quaternion dest) {
    if (quaternions == null) {
      return dest.setIdentity();
    }
    int at = sample * DOUBLES_PER_QUATERNION;
    return dest.set(quaternions[at], quaternions[at + 1], quaternions[at + 2], quaternions[at + 3]);
  }
}
