package org.palpate.raycast;

/** Whether what is empty is passed in one step, and how often it was. One thread. */
final class EmptySpaceSkipper {
  /** The switch. */
  final boolean on;

  /** Bricks, blocks of bricks and boxes in a brick that were passed in one step. */
  long bricks;

  /** Rays that lay beside the box of all solids. */
  long beside;

  EmptySpaceSkipper(boolean on) {
    this.on = on;
  }
}
