package org.palpate.assess;

import org.palpate.frame.FrameRecord;
import org.palpate.geometry.Vec3;

/**
 * The course of a session in at most {@link #MOST} rows of equal length: force, contact, and the
 * position of the tool. If a session is longer, two rows become one and the length doubles, so that
 * memory stays bounded.
 *
 * <p>One thread. A row without a frame is left out by the reader.
 */
public final class SessionCourse {
  /** The most rows. */
  static final int MOST = 4096;

  private static final double FIRST_SECONDS_A_ROW = 0.01;

  private final int[] frames = new int[MOST];
  private final int[] touching = new int[MOST];
  private final int[] forbidden = new int[MOST];
  private final double[] largest = new double[MOST];
  private final double[] sum = new double[MOST];
  private final double[][] position = new double[3][MOST];

  /** The number of first rows that have become one, a power of two. */
  private long merged = 1;

  private int rows;

  SessionCourse() {}

  /** Adds a frame; one from before the last row counts in the last row. */
  void add(FrameRecord frame, double atSeconds, boolean touchesForbidden) {
    long first = (long) (Math.max(0, atSeconds) / FIRST_SECONDS_A_ROW);
    while (first / merged >= MOST) {
      mergePairs();
    }
    int row = Math.max((int) (first / merged), rows - 1);
    rows = row + 1;
    frames[row]++;
    touching[row] += frame.contact ? 1 : 0;
    forbidden[row] += touchesForbidden ? 1 : 0;
    largest[row] = Math.max(largest[row], frame.pressingNewton);
    sum[row] += frame.pressingNewton;
    for (int axis = 0; axis < 3; axis++) {
      position[axis][row] = frame.tool.translation.get(axis);
    }
  }

  private void mergePairs() {
    for (int row = 0; row < MOST / 2; row++) {
      int one = 2 * row;
      int other = one + 1;
      largest[row] = Math.max(largest[one], largest[other]);
      sum[row] = sum[one] + sum[other];
      for (double[] axis : position) {
        axis[row] = axis[frames[other] > 0 ? other : one];
      }
      touching[row] = touching[one] + touching[other];
      forbidden[row] = forbidden[one] + forbidden[other];
      frames[row] = frames[one] + frames[other];
    }
    for (int row = MOST / 2; row < MOST; row++) {
      frames[row] = 0;
      touching[row] = 0;
      forbidden[row] = 0;
      largest[row] = 0;
      sum[row] = 0;
    }
    rows = (rows + 1) / 2;
    merged *= 2;
  }

  /** {@return the number of rows} */
  public int rows() {
    return rows;
  }

  /**
   * {@return whether a row has a frame}
   *
   * @param row the number of the row, from 0
   */
  public boolean hasFrames(int row) {
    return frames[row] > 0;
  }

  /**
   * {@return the middle of a row, s}
   *
   * @param row the number of the row, from 0
   */
  public double seconds(int row) {
    return (row + 0.5) * merged * FIRST_SECONDS_A_ROW;
  }

  /**
   * {@return the largest force of contact in a row, N}
   *
   * @param row the number of a row with frames
   */
  public double largestNewton(int row) {
    return largest[row];
  }

  /**
   * {@return the mean force of contact in a row, N; frames without contact count}
   *
   * @param row the number of a row with frames
   */
  public double meanNewton(int row) {
    return sum[row] / frames[row];
  }

  /**
   * {@return the part of the frames of a row that were in contact}
   *
   * @param row the number of a row with frames
   */
  public double contact(int row) {
    return (double) touching[row] / frames[row];
  }

  /**
   * {@return the part of the frames of a row that touched a protected segment}
   *
   * @param row the number of a row with frames
   */
  public double forbidden(int row) {
    return (double) forbidden[row] / frames[row];
  }

  /**
   * Writes where the tool was in the last frame of a row.
   *
   * @param row the number of a row with frames
   * @param dest receives the position, mm, in the frame of the records
   * @return {@code dest}
   */
  public Vec3 positionMm(int row, Vec3 dest) {
    return dest.set(position[0][row], position[1][row], position[2][row]);
  }
}
