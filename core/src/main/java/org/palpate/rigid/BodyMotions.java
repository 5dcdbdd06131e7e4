package org.palpate.rigid;

import org.palpate.geometry.Pose;

/**
 * The motions of bodies in one frame, in the order in which they were committed, one for each body
 * that moved. A motion that pushed the tool was committed together with a step of the tool's path;
 * in all others the tool stood still. Written by the haptic thread.
 */
public final class BodyMotions {
  /** The number of the step of a motion in which the tool stood still. */
  public static final int NO_STEP = -1;

  private final int[] body;
  private final int[] toolStep;
  private final Pose[] from;
  private final Pose[] to;
  private int count;

  BodyMotions(int bodies) {
    body = new int[bodies];
    toolStep = new int[bodies];
    from = new Pose[bodies];
    to = new Pose[bodies];
    for (int n = 0; n < bodies; n++) {
      from[n] = new Pose();
      to[n] = new Pose();
    }
  }

  /** {@return the number of motions} */
  public int count() {
    return count;
  }

  /**
   * {@return the index of the body that moved}
   *
   * @param motion the number of the motion, from 0 to {@link #count} - 1
   */
  public int body(int motion) {
    return body[motion];
  }

  /**
   * {@return the step of the tool's path that happened at the same time, or {@link #NO_STEP}}
   *
   * @param motion the number of the motion, from 0 to {@link #count} - 1
   */
  public int toolStep(int motion) {
    return toolStep[motion];
  }

  /**
   * {@return the body's pose before the motion, rest to present; not to be written}
   *
   * @param motion the number of the motion, from 0 to {@link #count} - 1
   */
  public Pose from(int motion) {
    return from[motion];
  }

  /**
   * {@return the body's pose after the motion, rest to present; not to be written}
   *
   * @param motion the number of the motion, from 0 to {@link #count} - 1
   */
  public Pose to(int motion) {
    return to[motion];
  }

  void clear() {
    count = 0;
  }

  void add(int index, Pose before, Pose after, int step) {
    body[count] = index;
    toolStep[count] = step;
    from[count].set(before);
    to[count++].set(after);
  }
}
