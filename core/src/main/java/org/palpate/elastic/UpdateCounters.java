package org.palpate.elastic;

/** Counts updates. The thread of the updates writes; read them after it has ended. */
public final class UpdateCounters {
  private long updates;
  private long scaledBack;
  private long refused;
  private double worstResidual;

  void count(boolean wasScaledBack) {
    updates++;
    scaledBack += wasScaledBack ? 1 : 0;
  }

  void countRefused() {
    refused++;
  }

  void noteResidual(double relative) {
    worstResidual = Math.max(worstResidual, relative);
  }

  /** Returns the number of updates. */
  public long updates() {
    return updates;
  }

  /** Returns the number of updates that would have folded a cell and were scaled back. */
  public long scaledBack() {
    return scaledBack;
  }

  /** Returns the number of updates that could not be proved and were not used. */
  public long refused() {
    return refused;
  }

  /** Returns the largest residual that an update left, over its load. */
  public double worstResidual() {
    return worstResidual;
  }
}
