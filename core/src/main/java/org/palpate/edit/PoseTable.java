package org.palpate.edit;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/** Keeps poses to the bit, in rows of one for each body. One thread at a time. */
final class PoseTable {
  private static final int NUMBERS = 7;

  private final int columns;
  private final double[] numbers;

  /** Creates a table of zeros. */
  PoseTable(int rows, int columns) {
    this.columns = columns;
    numbers = new double[Math.multiplyExact(rows, columns) * NUMBERS];
  }

  private int at(int row, int column) {
    return (row * columns + column) * NUMBERS;
  }

  /** Sets a pose. */
  void set(int row, int column, Pose pose) {
    int at = at(row, column);
    Vec3 translation = pose.translation;
    Quaternion rotation = pose.rotation;
    numbers[at] = translation.x;
    numbers[at + 1] = translation.y;
    numbers[at + 2] = translation.z;
    numbers[at + 3] = rotation.w;
    numbers[at + 4] = rotation.x;
    numbers[at + 5] = rotation.y;
    numbers[at + 6] = rotation.z;
  }

  /** Writes a pose and returns it. */
  Pose get(int row, int column, Pose dest) {
    int at = at(row, column);
    dest.translation.set(numbers[at], numbers[at + 1], numbers[at + 2]);
    dest.rotation.set(numbers[at + 3], numbers[at + 4], numbers[at + 5], numbers[at + 6]);
    return dest;
  }
}
