package org.palpate.raycast;

/** Holds whether a ray passes empty space in one step, and counts how often it did. One thread. */
final class EmptySpaceSkipper {
  /** Whether empty bricks are passed in one step; false only in tests and benchmarks. */
  final boolean enabled;

  /** The number of bricks, blocks of bricks and boxes in a brick that were passed in one step. */
  long skippedBricks;

  /** The number of rays that lay beside the box of all solids. */
  long raysBesideBounds;

  EmptySpaceSkipper(boolean enabled) {
    this.enabled = enabled;
  }
}
