package org.palpate.recording;

/**
 * A ring buffer of changes of voxels from the haptic thread to a file.
 *
 * <p>One writer, the haptic thread. One reader, a {@link RecordingThread}. A full buffer drops the
 * newest change and counts it.
 */
public final class EditRecorder {
  /** The usual capacity: over a hundred frames of the largest edits. */
  public static final int DEFAULT_CAPACITY = 1 << 18;

  private static final int WORDS_A_CHANGE = 3;
  private static final int COORDINATE_BITS = 31;
  private static final long COORDINATE = (1L << COORDINATE_BITS) - 1;

  private final WordRing ring;

  /** Receives the recorded changes. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Receives a change.
     *
     * @param sample number of the device sample with which a replay makes the change, from 0
     * @param segment index of the segment in the scene
     * @param i the voxel's number along x
     * @param j its number along y
     * @param k its number along z
     * @param solid whether voxel (i,j,k) became solid; otherwise it became empty
     */
    void accept(long sample, int segment, int i, int j, int k, boolean solid);
  }

  /** Makes an empty buffer of the usual capacity. */
  public EditRecorder() {
    this(DEFAULT_CAPACITY);
  }

  /**
   * Makes an empty buffer.
   *
   * @param capacity the number of changes that it holds, at least 1
   */
  public EditRecorder(int capacity) {
    ring = new WordRing(capacity, WORDS_A_CHANGE);
  }

  /**
   * Adds a change; see {@link Sink#accept}. Haptic thread: never waits, allocates nothing.
   *
   * @param sample number of the device sample with which a replay makes the change, from 0
   * @param segment index of the segment in the scene
   * @param i the voxel's number along x
   * @param j its number along y
   * @param k its number along z
   * @param solid whether the voxel became solid; otherwise it became empty
   */
  public void offer(long sample, int segment, int i, int j, int k, boolean solid) {
    int from = ring.claim();
    if (from == WordRing.FULL) {
      return;
    }
    ring.set(from, sample);
    ring.set(from + 1, (long) segment << COORDINATE_BITS | i);
    ring.set(from + 2, (long) j << COORDINATE_BITS | k | (solid ? Long.MIN_VALUE : 0));
    ring.publish();
  }

  /**
   * Moves all changes from the buffer into a sink. Reader.
   *
   * @param sink receives the changes in the order in which they were added
   */
  public void drainTo(Sink sink) {
    for (int left = ring.available(); left > 0; left--) {
      int from = ring.oldest();
      long first = ring.get(from + 1);
      long second = ring.get(from + 2);
      sink.accept(
          ring.get(from),
          (int) (first >>> COORDINATE_BITS),
          (int) (first & COORDINATE),
          (int) (second >>> COORDINATE_BITS & COORDINATE),
          (int) (second & COORDINATE),
          second < 0);
      ring.release();
    }
  }

  /** {@return the number of changes that were dropped because the buffer was full} Any thread. */
  public long overflows() {
    return ring.overflows();
  }
}
