package org.palpate.force.guide;

import org.palpate.geometry.Pose;

/** A pose at which a body that the hand holds would fit. Immutable; nobody writes to its parts. */
public final class FitTarget {
  /** Displacement and rotation. */
  static final int FREEDOMS = 6;

  private final int body;
  private final Pose pose;
  private final double leverMm;
  private final double[] pull;

  /**
   * Creates a target.
   *
   * @param body the index of the body
   * @param pose the pose of its reference point, world mm
   * @param leverMm a rotation counts as its angle times this, mm
   * @param pull a symmetric matrix of 6 by 6, row by row. It maps a displacement in mm and a
   *     rotation times the lever to the part that the fit determines.
   * @throws IllegalArgumentException if the matrix has another size
   */
  public FitTarget(int body, Pose pose, double leverMm, double[] pull) {
    if (pull.length != FREEDOMS * FREEDOMS) {
      throw new IllegalArgumentException("a pull has 36 entries: pull=" + pull.length);
    }
    this.body = body;
    this.pose = pose;
    this.leverMm = leverMm;
    this.pull = pull.clone();
  }

  /** Returns the index of the body. */
  int body() {
    return body;
  }

  /** {@return the pose of the body's reference point, world mm} */
  public Pose pose() {
    return pose;
  }

  /** Returns the lever of rotations, mm. */
  double leverMm() {
    return leverMm;
  }

  /**
   * {@return an entry of the matrix}
   *
   * @param entry the number of the entry, from 0 to 35, row by row
   */
  public double pull(int entry) {
    return pull[entry];
  }
}
