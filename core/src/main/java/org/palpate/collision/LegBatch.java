package org.palpate.collision;

import org.palpate.geometry.AffineMap;

/**
 * Judges the legs of all points of a set in one motion. A leg is the segment between the images of
 * a point under two maps; see {@link AffineMap} for their bits. One thread at a time; allocates
 * nothing.
 */
public interface LegBatch {
  /** The {@link #crossover} of a device that is never faster. */
  long NEVER = Long.MAX_VALUE;

  /**
   * Returns the number of legs from which this batch is faster than judging each by itself, as far
   * as was measured.
   */
  long crossover();

  /**
   * Judges the leg of each point.
   *
   * @param from the map to the grid coordinates of the voxels at the start of the motion
   * @param to the map at its end
   * @return whether there are verdicts; false if the device has failed
   */
  boolean judge(AffineMap from, AffineMap to);

  /** Returns the verdict on the leg of a point by the last call of {@link #judge}. */
  LegVerdict verdict(int point);
}
