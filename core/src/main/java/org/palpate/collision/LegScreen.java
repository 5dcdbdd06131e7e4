package org.palpate.collision;

import org.palpate.geometry.AffineMap;

/**
 * Finds free legs of a motion by a {@link LegBatch} if that is faster than judging them one by one.
 * The choice depends on how many legs remained after culling in earlier motions, so it adapts to
 * the scene. It changes no answer, because the caller judges the other legs exactly.
 *
 * <p>Motions that may follow from the same start can be announced. A device that takes several at
 * once then judges them in the same launch, and its verdicts are kept until the start or the voxels
 * change.
 *
 * <p>One thread; allocates nothing.
 */
public final class LegScreen {
  private final LegBatch batch;
  private final MotionGroup announced = new MotionGroup();
  private final MotionGroup judged = new MotionGroup();
  private long judgedVersion;
  private long remaining;
  private int motion = MotionGroup.NONE;

  /**
   * Creates a screen that has seen no motion yet.
   *
   * @param batch judges legs in launches; belongs to the screen from now on
   */
  public LegScreen(LegBatch batch) {
    this.batch = batch;
  }

  /** {@return whether it pays to announce motions} */
  public boolean takesAnnouncements() {
    return batch.motionsAtOnce() > 1;
  }

  /**
   * Announces a motion that may begin soon. Too many are left out.
   *
   * @param from from the frame of the points to grid coordinates, at the start
   * @param to the same at the end
   * @param first whether to forget those that were announced before
   */
  public void announce(AffineMap from, AffineMap to, boolean first) {
    if (first) {
      announced.begin(from);
    }
    if (announced.count() < batch.motionsAtOnce()) {
      announced.add(to);
    }
  }

  /**
   * Begins a motion, and judges its legs in a batch if that is expected to be faster.
   *
   * @param from from the frame of the points to grid coordinates, at the start
   * @param to the same at the end
   * @param version the version of the voxels, which changes with them
   */
  public void begin(AffineMap from, AffineMap to, long version) {
    motion = version == judgedVersion ? judged.indexOf(from, to) : MotionGroup.NONE;
    if (motion == MotionGroup.NONE && remaining >= batch.crossover()) {
      judge(from, to);
      judgedVersion = version;
    }
  }

  /** Judges a motion, together with the announced ones if it is among them. */
  private void judge(AffineMap from, AffineMap to) {
    motion = announced.indexOf(from, to);
    if (motion == MotionGroup.NONE) {
      judged.begin(from);
      judged.add(to);
      motion = 0;
    } else {
      judged.set(announced);
    }
    if (!batch.judge(judged)) {
      judged.begin(from);
      motion = MotionGroup.NONE;
    }
  }

  /**
   * {@return whether the leg of a point is known to be free}
   *
   * @param point the index of the point
   */
  public boolean isFree(int point) {
    return motion != MotionGroup.NONE && batch.verdict(motion, point) == LegVerdict.FREE;
  }

  /**
   * {@return half the edge of an empty cube around the start of a leg that is known to be free; see
   * {@link LegBatch#emptyAround}}
   *
   * @param point the index of the point
   */
  public double emptyAround(int point) {
    return batch.emptyAround(point);
  }

  /**
   * Ends a motion; no leg is known to be free any more.
   *
   * @param legs the number of legs that remained after culling
   * @param all whether all legs were counted; false if verification ended at an early hit
   */
  public void end(long legs, boolean all) {
    motion = MotionGroup.NONE;
    remaining = all ? legs : Math.max(remaining, legs);
  }
}
