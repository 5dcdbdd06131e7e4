package org.palpate.io.volume;

/** Receives the progress of reading. */
@FunctionalInterface
public interface ReadProgress {
  /** Ignores the progress. */
  ReadProgress NONE = (done, total) -> {};

  /**
   * Reports that {@code done} of {@code total} slices were read; called after each slice, on the
   * reading thread.
   */
  void slicesRead(int done, int total);
}
