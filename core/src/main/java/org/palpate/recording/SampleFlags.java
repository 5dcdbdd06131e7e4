package org.palpate.recording;

/** The faults of a recorded sample. The code is the column {@code flags} of a trajectory file. */
public enum SampleFlags {
  /** The sample has no fault. */
  NONE(0),
  /** The position is NaN or infinite. */
  NOT_FINITE(1),
  /** The time lies before that of the last sample. */
  BACKWARD_TIME(2),
  /** Both faults. */
  NOT_FINITE_AND_BACKWARD_TIME(3);

  private final int code;

  SampleFlags(int code) {
    this.code = code;
  }

  /** Returns the flags of a sample with these faults. */
  static SampleFlags of(boolean notFinite, boolean backwardTime) {
    if (notFinite) {
      return backwardTime ? NOT_FINITE_AND_BACKWARD_TIME : NOT_FINITE;
    }
    return backwardTime ? BACKWARD_TIME : NONE;
  }

  /** {@return the code in a trajectory file: 1 for not finite plus 2 for a backward time} */
  public int code() {
    return code;
  }
}
