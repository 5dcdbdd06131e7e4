package org.palpate.rigid;

/**
 * Bounds the work of a frame by counting it: a look at a point costs 1, about 50 ns. Counted as if
 * nothing had been left out, so that the same poses give the same bits with and without skips.
 */
final class WorkBudget {
  private static final long QP_COST = 25;
  private static final long FIELD_COST = 10;

  /** The work that a frame may always use. */
  private static final long LEAST_BUDGET = 12_000;

  /** The number of verifications of all points near solids that a frame may use as well. */
  private static final long VERIFICATIONS = 5;

  private final ToolVerifier verifier;
  private long testedBefore;
  private long extra;
  private long largestVerification;

  WorkBudget(ToolVerifier verifier) {
    this.verifier = verifier;
  }

  void begin() {
    testedBefore = verifier.tested();
    extra = 0;
    largestVerification -= largestVerification >> 5;
  }

  void countSolve() {
    extra += QP_COST;
  }

  void countField() {
    extra += FIELD_COST;
  }

  /** Takes note of how many points a complete verification looked at. */
  void countVerification(long tested) {
    largestVerification = Math.max(largestVerification, tested);
  }

  /** Returns the work of the frame so far. */
  long work() {
    return verifier.tested() - testedBefore + extra;
  }

  boolean isSpent() {
    return work() >= Math.max(LEAST_BUDGET, VERIFICATIONS * largestVerification);
  }
}
