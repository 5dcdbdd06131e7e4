package org.palpate.force.guide;

/**
 * Hands the newest fit of a held body to the haptic thread. One thread offers fits, and {@link
 * FitGuide} takes the newest; neither waits.
 */
public final class FitExchange {
  private volatile FitTarget newest;

  /**
   * Replaces the fit.
   *
   * @param fit the newest fit; null for none
   */
  public void offer(FitTarget fit) {
    newest = fit;
  }

  /** Returns the newest fit; null if there is none. */
  FitTarget newest() {
    return newest;
  }
}
