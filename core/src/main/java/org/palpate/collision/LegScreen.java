package org.palpate.collision;

import org.palpate.geometry.AffineMap;

/**
 * Finds free legs of a motion by a {@link LegBatch} if that is faster than judging them one by one.
 * The choice depends on the number of legs that the last motions left to judge after culling, so it
 * follows the scene. It changes no answer, because the caller judges the other legs exactly.
 *
 * <p>One thread; allocates nothing.
 */
public final class LegScreen {
  private final LegBatch batch;
  private long expected;
  private boolean judged;

  /** Creates a screen that has seen no motion yet. */
  public LegScreen(LegBatch batch) {
    this.batch = batch;
  }

  /** Judges the legs of a motion if that pays. */
  public void begin(AffineMap from, AffineMap to) {
    judged = expected >= batch.crossover() && batch.judge(from, to);
  }

  /** Whether the leg of a point is known to be free. */
  public boolean isFree(int point) {
    return judged && batch.verdict(point) == LegVerdict.FREE;
  }

  /**
   * Ends a motion; no leg is known to be free any more.
   *
   * @param legs the number of legs that were left to judge
   * @param all whether these were all, because no leg ended the verification early
   */
  public void end(long legs, boolean all) {
    judged = false;
    expected = all ? legs : Math.max(expected, legs);
  }
}
