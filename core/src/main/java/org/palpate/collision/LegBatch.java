package org.palpate.collision;

/**
 * Judges the legs of all points of a set in some motions at once. A leg is the segment between the
 * images of a point under the two maps of a motion; see {@link org.palpate.geometry.AffineMap} for
 * their bits. One thread at a time; allocates nothing.
 */
public interface LegBatch {
  /** The {@link #crossover} of a device that is never faster. */
  long NEVER = Long.MAX_VALUE;

  /**
   * {@return the number of legs of a motion from which this batch is faster than judging each by
   * itself, as far as was measured}
   */
  long crossover();

  /**
   * {@return the number of motions that take little longer together than one alone, as far as was
   * measured: from 1 to {@link MotionGroup#CAPACITY}}
   */
  int motionsAtOnce();

  /**
   * Judges the leg of each point in each motion. Motions are between grid coordinates of the
   * voxels.
   *
   * @param motions the maps from the frame of the points to grid coordinates
   * @return whether there are verdicts; false if the device has failed
   */
  boolean judge(MotionGroup motions);

  /**
   * {@return the verdict on the leg of a point in a motion by the last call of {@link #judge}}
   *
   * @param motion the index of the motion in the group that was judged
   * @param point the index of the point
   */
  LegVerdict verdict(int motion, int point);

  /**
   * {@return half the edge, voxels, of a closed cube that touches no solid voxel} The cube lies
   * around the point where the motions of the last call of {@link #judge} start. The result is at
   * least 0; a device need not find the largest cube.
   *
   * @param point the index of the point
   */
  double emptyAround(int point);
}
