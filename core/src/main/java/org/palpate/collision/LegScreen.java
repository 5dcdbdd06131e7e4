package org.palpate.collision;

import org.palpate.geometry.AffineMap;

/**
 * Finds free legs of a motion by a {@link LegBatch} if that is faster than judging them one by one.
 * The choice depends on how many legs remained after culling in earlier motions, so it adapts to
 * the scene. It changes no answer, because the caller judges the other legs exactly.
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

  /** Begins a motion, and judges its legs in a batch if that is expected to be faster. */
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
   * @param legs the number of legs that remained after culling
   * @param all whether all legs were counted; false if verification ended at an early hit
   */
  public void end(long legs, boolean all) {
    judged = false;
    expected = all ? legs : Math.max(expected, legs);
  }
}
