package org.palpate.benchmarks.elastic;

/** The pace of the updates in an attack. */
enum UpdatePace {
  /** Updates come in time, but stop for up to half a second once in some thousand frames. */
  USUAL(3_000, 1_000, 500, 60),

  /**
   * After almost every update the next ones stop for up to 8 seconds. So each field meets many
   * frames. Updates take most of the time, so a processor then judges many more legs a second.
   */
  RARE(30_000, 33, 8_000, 600);

  /** The frames of one scene. */
  final int framesPerRound;

  /** A stop begins in one of so many frames. */
  final int framesPerStop;

  final int longestStopFrames;

  /** All tetrahedra are judged once in so many frames. */
  final int framesPerJudgement;

  UpdatePace(int framesPerRound, int framesPerStop, int longestStopFrames, int framesPerJudgement) {
    this.framesPerRound = framesPerRound;
    this.framesPerStop = framesPerStop;
    this.longestStopFrames = longestStopFrames;
    this.framesPerJudgement = framesPerJudgement;
  }
}
