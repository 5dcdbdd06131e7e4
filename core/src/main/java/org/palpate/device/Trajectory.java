package org.palpate.device;

import java.util.Arrays;

/**
 * Samples of a device in memory, in order: what a trajectory file holds. Positions are whatever
 * their reader says, world mm or grid coordinates; nothing is checked, so that a NaN can be met as
 * a live session would meet it.
 *
 * <p>Filled by one thread, then read by any.
 */
public final class Trajectory {
  private static final int X = 0;
  private static final int Y = 1;
  private static final int Z = 2;
  private static final int QX = 3;
  private static final int QY = 4;
  private static final int QZ = 5;
  private static final int QW = 6;
  private static final int DOUBLES_A_SAMPLE = 7;
  private static final double NANOS_PER_MS = 1e6;

  private double[] timesMs = new double[1024];
  private double[] values = new double[1024 * DOUBLES_A_SAMPLE];
  private int size;

  /** Adds a sample without orientation. */
  public void add(double timeMs, double x, double y, double z) {
    add(timeMs, x, y, z, 0, 0, 0, 1);
  }

  /** Adds a sample; the quaternion is a unit one. */
  public void add(
      double timeMs, double x, double y, double z, double qx, double qy, double qz, double qw) {
    if (size == timesMs.length) {
      timesMs = Arrays.copyOf(timesMs, 2 * size);
      values = Arrays.copyOf(values, 2 * size * DOUBLES_A_SAMPLE);
    }
    int at = size * DOUBLES_A_SAMPLE;
    values[at + X] = x;
    values[at + Y] = y;
    values[at + Z] = z;
    values[at + QX] = qx;
    values[at + QY] = qy;
    values[at + QZ] = qz;
    values[at + QW] = qw;
    timesMs[size++] = timeMs;
  }

  public int size() {
    return size;
  }

  /** The time of a sample as it was given, ms. */
  public double timeMs(int sample) {
    return timesMs[sample];
  }

  /** Writes a sample into {@code dest}; its buttons are left alone. */
  public void read(int sample, DeviceState dest) {
    int at = sample * DOUBLES_A_SAMPLE;
    dest.positionMm.set(values[at + X], values[at + Y], values[at + Z]);
    dest.qx = values[at + QX];
    dest.qy = values[at + QY];
    dest.qz = values[at + QZ];
    dest.qw = values[at + QW];
    dest.timeNanos = Math.round(timesMs[sample] * NANOS_PER_MS);
  }
}
