package org.palpate.recording;

import org.palpate.device.DeviceState;

/**
 * A ring buffer of samples from the haptic thread to a file.
 *
 * <p>One writer, the haptic thread, through a {@link RecordingDevice}. One reader, a {@link
 * RecordingThread}. Samples arrive bit for bit, NaN included. A full buffer drops the newest sample
 * and counts it.
 */
public final class SampleRecorder {
  /** The usual capacity: six seconds at 10 kHz, 5 MB. */
  public static final int DEFAULT_CAPACITY = 1 << 16;

  private static final int TIME = 0;
  private static final int POSE = 1;
  private static final int BUTTONS = POSE + WordRing.WORDS_A_POSE;
  private static final int WORDS_A_SAMPLE = BUTTONS + 1;

  /** The lower half of the word of the buttons; the upper half holds {@link #RELOCATED}. */
  private static final long BUTTONS_MASK = 0xffffffffL;

  private static final long RELOCATED = 1L << 32;

  private final WordRing ring;
  private final DeviceState out = new DeviceState();
  private long lastTimeNanos = Long.MIN_VALUE;

  /** Receives the recorded samples. */
  public interface Sink {
    /**
     * Receives one sample.
     *
     * @param sample as the device sent it; belongs to the recorder and changes with the next sample
     * @param flags faults of the sample
     */
    void accept(DeviceState sample, SampleFlags flags);
  }

  /** Makes an empty buffer of the usual capacity. */
  public SampleRecorder() {
    this(DEFAULT_CAPACITY);
  }

  /**
   * Makes an empty buffer.
   *
   * @param capacity the number of samples that it holds, at least 1
   */
  public SampleRecorder(int capacity) {
    ring = new WordRing(capacity, WORDS_A_SAMPLE);
  }

  /**
   * Adds a sample. Haptic thread: never waits, allocates nothing.
   *
   * @param sample the sample; copied
   */
  public void offer(DeviceState sample) {
    int from = ring.claim();
    if (from == WordRing.FULL) {
      return;
    }
    ring.set(from + TIME, sample.timeNanos);
    ring.set(from + POSE, sample.positionMm, sample.orientation);
    ring.set(from + BUTTONS, (sample.buttons & BUTTONS_MASK) | (sample.relocated ? RELOCATED : 0));
    ring.publish();
  }

  /**
   * Moves all samples from the buffer into a sink. Reader.
   *
   * @param sink receives the samples in the order in which they were added; they are overwritten
   *     after each call
   * @return number of samples
   */
  public int drainTo(Sink sink) {
    int count = ring.available();
    for (int n = 0; n < count; n++) {
      read(ring.oldest());
      SampleFlags flags = flags();
      lastTimeNanos = out.timeNanos;
      sink.accept(out, flags);
      ring.release();
    }
    return count;
  }

  private void read(int from) {
    out.timeNanos = ring.get(from + TIME);
    ring.get(from + POSE, out.positionMm, out.orientation);
    out.buttons = (int) ring.get(from + BUTTONS);
    out.relocated = (ring.get(from + BUTTONS) & RELOCATED) != 0;
  }

  private SampleFlags flags() {
    boolean backwardTime = out.timeNanos < lastTimeNanos;
    return SampleFlags.of(!out.positionMm.isFinite(), backwardTime);
  }

  /** {@return the number of samples that were dropped because the buffer was full} Any thread. */
  public long overflows() {
    return ring.overflows();
  }
}
