package org.palpate.rigid.skip;

/**
 * Decides whether a screen of points is asked. Points that a screen has not found are tested, and a
 * test may free a point for many motions. So a screen may cost more than it saves, although it
 * finds many points.
 *
 * <p>After some verifications that ask the screen, a few do not. If these cost less in the end, the
 * screen is left out until a verification costs far more. Costs are counts of points and of
 * answers, never times. A verification without the screen that becomes too dear asks it again at
 * once.
 *
 * <p>Haptic thread only; allocates nothing.
 */
final class ScreenTrial {
  /** The work of an answer, tested points. */
  private static final int ANSWER_COST = 4;

  /** The verifications that ask the screen before one trial without it; doubles if it fails. */
  private static final int FIRST_PERIOD = 64;

  private static final int LONGEST_PERIOD = 1 << 14;

  /** The verifications of a trial. */
  private static final int TRIAL = 8;

  /** The last verifications of a trial, whose costs count. */
  private static final int SETTLED = 4;

  /** A verification without the screen asks it again if it costs this many times the usual. */
  private static final int TOO_DEAR = 4;

  /** The part by which the usual cost follows the last one. */
  private static final double SHARE = 1.0 / 16;

  private boolean asks = true;
  private int period = FIRST_PERIOD;

  /** The verifications until a trial begins or ends; 0 after a trial that went well. */
  private int left = FIRST_PERIOD;

  /** The mean cost of a verification that asks the screen, tested points. */
  private double usualCost;

  private long cost;
  private long settledCost;

  /** Begins a verification. */
  void begin() {
    cost = 0;
  }

  /**
   * Comes to points that are tested if the screen is not asked. If they have become too many, it is
   * asked again.
   */
  void comeTo(int points) {
    if (!asks) {
      cost += points;
      if (cost > TOO_DEAR * usualCost) {
        askAgain();
      }
    }
  }

  /** Whether to ask the screen. */
  boolean asks() {
    return asks;
  }

  /** Counts an answer of the screen. */
  void countAnswer() {
    cost += ANSWER_COST;
  }

  /** Counts points that the screen has not found. */
  void countPoints(int points) {
    cost += points;
  }

  /** Ends a verification. */
  void end() {
    if (asks) {
      usualCost += SHARE * (cost - usualCost);
      if (--left == 0) {
        asks = false;
        left = TRIAL;
        settledCost = 0;
      }
    } else if (left > 0) {
      settledCost += left-- <= SETTLED ? cost : 0;
      if (left == 0 && settledCost >= SETTLED * usualCost) {
        askAgain();
      }
    }
  }

  private void askAgain() {
    asks = true;
    period = Math.min(LONGEST_PERIOD, 2 * period);
    left = period;
  }
}
