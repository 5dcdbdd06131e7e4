package org.palpate.rigid;

/**
 * Counts the work of a frame and bounds it. The unit is the test of one point, about 50 ns. Work is
 * counted as if nothing were skipped, so that results are the same with and without skips.
 *
 * <p>It also says which lifts and which steps along faces of voxels a frame may try. While the
 * device moves and lifts do not help, lifts become rarer. Haptic thread only.
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

  /** The fractions of the motion to the device that the lifts of a frame request, in order. */
  private static final double[] PULLS = {0.02, 0, 0.1};

  /** The most frames between two that try a lift while the device moves. */
  private static final int LONGEST_PAUSE = 16;

  private final MoverVerifier verifier;
  private long testedBefore;
  private long otherWork;
  private long largestVerification;
  private boolean moves;
  private int liftPause = 1;
  private int pauseLeft;
  private int nextLift;

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

  /** Returns the work after which the frame must end. */
  long limit() {
    return Math.max(LEAST_BUDGET, VERIFICATIONS * largestVerification);
  }

  /** Whether the frame must end. */
  boolean isSpent() {
    return work() >= limit();
  }

  /** Whether a step must end. One along faces has a smaller budget. */
  boolean isSpent(boolean alongFaces) {
    return isSpent() || (alongFaces && !hasFaces());
  }

  /**
   * Whether a step along faces may begin, or try another part. While the device moves it may do so
   * during the first half of the budget, but always during {@link #LEAST_BUDGET}.
   */
  boolean hasFaces() {
    return !moves || work() < Math.max(LEAST_BUDGET, limit() / 2);
  }

  /** Lets the next frame try lifts. */
  void allowLifts() {
    liftPause = 1;
    pauseLeft = 0;
  }

  /**
   * Begins the steps of a frame. It may try lifts if the device rests or the pause is over.
   *
   * @param deviceMoves whether the device has moved since the last frame
   */
  void beginApproach(boolean deviceMoves) {
    moves = deviceMoves;
    nextLift = !moves || pauseLeft-- <= 0 ? 0 : PULLS.length;
  }

  /** Whether the frame may try another lift. */
  boolean hasLift() {
    return nextLift < PULLS.length;
  }

  /** Takes the next lift; returns the fraction of the motion to the device that it requests. */
  double nextPull() {
    return PULLS[nextLift++];
  }

  /**
   * Ends the lifts of a frame.
   *
   * @param hasGained whether the frame came nearer to the device by enough to matter
   */
  void endLifts(boolean hasGained) {
    if (hasGained) {
      allowLifts();
    } else if (pauseLeft < 0) {
      liftPause = Math.min(LONGEST_PAUSE, 2 * liftPause);
      pauseLeft = liftPause;
    }
  }
}
