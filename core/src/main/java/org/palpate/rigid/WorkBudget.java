package org.palpate.rigid;

/**
 * Counts the work of a frame and bounds it. The unit is the test of one point, about 50 ns. Work is
 * counted as if nothing were skipped, so that results are the same with and without skips. Haptic
 * thread only.
 */
final class WorkBudget {
  /** The work of solving a nearest-point problem. */
  private static final long SOLVE_COST = 25;

  /** The work of evaluating the field at a point. */
  private static final long FIELD_COST = 10;

  /** The work that a frame may always use. */
  static final long LEAST_BUDGET = 6_000;

  /** The number of complete verifications that a frame may always use. */
  private static final long VERIFICATIONS = 5;

  private final MoverVerifier verifier;
  private long testedBefore;
  private long otherWork;
  private long largestVerification;

  WorkBudget(MoverVerifier verifier) {
    this.verifier = verifier;
  }

  /** Begins a frame. */
  void begin() {
    testedBefore = verifier.tested();
    otherWork = 0;
    largestVerification -= largestVerification >> 5;
  }

  /** Counts the solution of a nearest-point problem. */
  void countSolve() {
    otherWork += SOLVE_COST;
  }

  /** Counts evaluations of the field. */
  void countField(int evaluations) {
    otherWork += evaluations * FIELD_COST;
  }

  /** Counts the points that a complete verification tested. */
  void countVerification(long tested) {
    largestVerification = Math.max(largestVerification, tested);
  }

  /** Returns the work of the frame so far. */
  long work() {
    return verifier.tested() - testedBefore + otherWork;
  }

  /** Whether the frame must end. */
  boolean isSpent() {
    return work() >= Math.max(LEAST_BUDGET, VERIFICATIONS * largestVerification);
  }
}
