package org.palpate.proxy.smooth;

import org.palpate.proxy.smooth.field.OccupancyField;

/**
 * The work budget of a frame, in windows of voxels that the field reads. They take most of the
 * time.
 *
 * <p>A frame that has spent its budget and made progress leaves the rest of a long path to the next
 * frame. A device that moves two voxels a frame needs one or two windows.
 */
final class WindowBudget {
  /** The windows of an ordinary frame. */
  private static final int WINDOWS = 3;

  /** The windows beyond the budget that a search may read to finish what it has begun. */
  private static final int OVERDRAFT = 5;

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

  /** Whether searches must stop and return their best result so far. */
  boolean isOverdrawn() {
    return field.windowReads() >= limit + OVERDRAFT;
  }
}
