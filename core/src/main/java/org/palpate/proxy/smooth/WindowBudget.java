package org.palpate.proxy.smooth;

import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * The work budget of a frame, in windows of voxels that the field reads. They take most of the
 * time.
 *
 * <p>A frame that has spent its budget and made progress leaves the rest of a long path to the next
 * frame. A device that moves two voxels a frame needs one or two windows. No frame reads more than
 * {@link #MOST_WINDOWS}, whatever the scene and the device do.
 */
final class WindowBudget {
  /** The windows of an ordinary frame. */
  private static final int WINDOWS = 3;

  /** The windows beyond the budget that a search may read to finish what it has begun. */
  private static final int OVERDRAFT = 5;

  /**
   * The windows that a frame may read after that, because they end what it does. Five belong to the
   * iteration of the slide: two intersections and three steps of searches. Two belong to the
   * potentials that decide whether the slide counts, and whether the way along the voxels does.
   */
  private static final int ENDING = 7;

  /** The windows that a frame reads at most. */
  static final int MOST_WINDOWS = WINDOWS + OVERDRAFT + ENDING;

  private final OccupancyField field;
  private long limit;

  WindowBudget(OccupancyField field) {
    this.field = field;
  }

  /** Begins a frame. */
  void beginFrame() {
    limit = field.windowReads() + WINDOWS;
  }

  /** Whether the budget is spent, so that the frame should end as soon as it has made progress. */
  boolean isSpent() {
    return field.windowReads() >= limit;
  }

  /** Whether searches must stop and return their best result so far, and no other may begin. */
  boolean isOverdrawn() {
    return field.windowReads() >= limit + OVERDRAFT;
  }
}
