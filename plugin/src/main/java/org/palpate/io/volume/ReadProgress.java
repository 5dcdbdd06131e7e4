package org.palpate.io.volume;

/** Is told how far reading has come. */
@FunctionalInterface
public interface ReadProgress {
  /** Tells no one. */
  ReadProgress NONE = (done, total) -> {};

  /** {@code done} of {@code total} slices were read; called once a slice, on the reading thread. */
  void slicesRead(int done, int total);
}
