package org.palpate.recording;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.device.DeviceState;

/**
 * A ring buffer of samples from the haptic thread to a file.
 *
 * <p>One writer, the haptic thread, through a {@link RecordingDevice}. One reader, a {@link
 * RecordingThread}. Samples arrive bit for bit, NaN included. A full buffer drops the newest sample
 * and counts it.
 */
public final class SampleRecorder {
  /** The usual capacity: some eight seconds at 1 kHz. */
  public static final int DEFAULT_CAPACITY = 8192;

  private static final int TIME = 0;
  private static final int X = 1;
  private static final int QW = 4;
  private static final int BUTTONS = 8;
  private static final int WORDS_A_SAMPLE = 9;

  /** The lower half of the word of the buttons; the upper half holds {@link #RELOCATED}. */
  private static final long BUTTONS_MASK = 0xffffffffL;

  private static final long RELOCATED = 1L << 32;

  private final long[] ring;
  private final int capacity;
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();
  private final AtomicLong overflows = new AtomicLong();
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

  /** Makes an empty buffer for {@code capacity} samples, at least 1. */
  public SampleRecorder(int capacity) {
    this.capacity = capacity;
    ring = new long[Math.multiplyExact(capacity, WORDS_A_SAMPLE)];
  }

  /** Adds a sample. Haptic thread: never waits, allocates nothing. */
  public void offer(DeviceState sample) {
    long at = written.getPlain();
    if (at - taken.get() >= capacity) {
      overflows.lazySet(overflows.getPlain() + 1);
      return;
    }
    int from = (int) (at % capacity) * WORDS_A_SAMPLE;
    ring[from + TIME] = sample.timeNanos;
    for (int axis = 0; axis < 3; axis++) {
      ring[from + X + axis] = Double.doubleToRawLongBits(sample.positionMm.get(axis));
    }
    ring[from + QW] = Double.doubleToRawLongBits(sample.orientation.w);
    ring[from + QW + 1] = Double.doubleToRawLongBits(sample.orientation.x);
    ring[from + QW + 2] = Double.doubleToRawLongBits(sample.orientation.y);
    ring[from + QW + 3] = Double.doubleToRawLongBits(sample.orientation.z);
    ring[from + BUTTONS] = (sample.buttons & BUTTONS_MASK) | (sample.relocated ? RELOCATED : 0);
    written.setRelease(at + 1);
  }

  /**
   * Moves all samples from the buffer into a sink. Reader.
   *
   * @return number of samples
   */
  public int drainTo(Sink sink) {
    long end = written.getAcquire();
    long at = taken.getPlain();
    int count = (int) (end - at);
    for (; at < end; at++) {
      read((int) (at % capacity) * WORDS_A_SAMPLE);
      SampleFlags flags = flags();
      lastTimeNanos = out.timeNanos;
      sink.accept(out, flags);
      taken.setRelease(at + 1);
    }
    return count;
  }

  private void read(int from) {
    out.timeNanos = ring[from + TIME];
    for (int axis = 0; axis < 3; axis++) {
      out.positionMm.set(axis, Double.longBitsToDouble(ring[from + X + axis]));
    }
    out.orientation.w = Double.longBitsToDouble(ring[from + QW]);
    out.orientation.x = Double.longBitsToDouble(ring[from + QW + 1]);
    out.orientation.y = Double.longBitsToDouble(ring[from + QW + 2]);
    out.orientation.z = Double.longBitsToDouble(ring[from + QW + 3]);
    out.buttons = (int) ring[from + BUTTONS];
    out.relocated = (ring[from + BUTTONS] & RELOCATED) != 0;
  }

  private SampleFlags flags() {
    boolean backwardTime = out.timeNanos < lastTimeNanos;
    return SampleFlags.of(!out.positionMm.isFinite(), backwardTime);
  }

  /** Returns the number of samples that were dropped because the buffer was full. Any thread. */
  public long overflows() {
    return overflows.get();
  }
}
