package org.palpate.frame;

/**
 * Receives what each frame did that followed a new sample. Haptic thread: an implementation
 * allocates nothing and never waits.
 */
@FunctionalInterface
public interface FrameObserver {
  /**
   * Receives a frame.
   *
   * @param record belongs to the caller and changes with the next frame
   */
  void accept(FrameRecord record);
}
