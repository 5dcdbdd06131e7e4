package org.palpate.recording;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.device.DeviceState;

/**
 * Samples on their way from the haptic thread to a file: a ring of primitives, one writer (the
 * haptic thread, through a {@link RecordingDevice}), one reader (a {@link RecordingThread}). Keeps
 * what the device sent, NaN too. A full ring loses the newest sample and counts it.
 */
public final class SampleRecorder {
  /** Some eight seconds at 1 kHz. */
  public static final int DEFAULT_CAPACITY = 8192;

  /** A sample as it should be. */
  public static final int FLAG_NONE = 0;

  /** Flag of a position that is NaN or infinite. */
  public static final int FLAG_NOT_FINITE = 1;

  /** Flag of a time before the one of the last sample. */
  public static final int FLAG_BACKWARD_TIME = 2;

  private static final int TIME = 0;
  private static final int X = 1;
  private static final int QX = 4;
  private static final int BUTTONS = 8;
  private static final int WORDS_A_SAMPLE = 9;

  private final long[] ring;
  private final int capacity;
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong read = new AtomicLong();
  private final AtomicLong overflows = new AtomicLong();
  private final DeviceState out = new DeviceState();
  private long lastTimeNanos = Long.MIN_VALUE;

  /** Takes what the reader is given. */
  public interface Sink {
    /**
     * Takes one sample.
     *
     * @param sample as the device sent it; the recorder's own, changed by the next
     * @param flags {@link #FLAG_NOT_FINITE} and {@link #FLAG_BACKWARD_TIME}, added
     */
    void accept(DeviceState sample, int flags);
  }

  public SampleRecorder() {
    this(DEFAULT_CAPACITY);
  }

  /** A ring for {@code capacity} samples, at least 1. */
  public SampleRecorder(int capacity) {
    this.capacity = capacity;
    ring = new long[Math.multiplyExact(capacity, WORDS_A_SAMPLE)];
  }

  /** Puts a sample in. Haptic thread: never waits, allocates nothing. */
  public void offer(DeviceState sample) {
    long at = written.getPlain();
    if (at - read.get() >= capacity) {
      overflows.lazySet(overflows.getPlain() + 1);
      return;
    }
    int from = (int) (at % capacity) * WORDS_A_SAMPLE;
    ring[from + TIME] = sample.timeNanos;
    for (int axis = 0; axis < 3; axis++) {
      ring[from + X + axis] = Double.doubleToRawLongBits(sample.positionMm.get(axis));
    }
    ring[from + QX] = Double.doubleToRawLongBits(sample.qx);
    ring[from + QX + 1] = Double.doubleToRawLongBits(sample.qy);
    ring[from + QX + 2] = Double.doubleToRawLongBits(sample.qz);
    ring[from + QX + 3] = Double.doubleToRawLongBits(sample.qw);
    ring[from + BUTTONS] = sample.buttons;
    written.setRelease(at + 1);
  }

  /**
   * Hands over everything that is in the ring. Reader.
   *
   * @return how many samples
   */
  public int drainTo(Sink sink) {
    long end = written.getAcquire();
    long at = read.getPlain();
    int count = (int) (end - at);
    for (; at < end; at++) {
      take((int) (at % capacity) * WORDS_A_SAMPLE);
      sink.accept(out, flags());
      read.setRelease(at + 1);
    }
    return count;
  }

  private void take(int from) {
    out.timeNanos = ring[from + TIME];
    for (int axis = 0; axis < 3; axis++) {
      out.positionMm.set(axis, Double.longBitsToDouble(ring[from + X + axis]));
    }
    out.qx = Double.longBitsToDouble(ring[from + QX]);
    out.qy = Double.longBitsToDouble(ring[from + QX + 1]);
    out.qz = Double.longBitsToDouble(ring[from + QX + 2]);
    out.qw = Double.longBitsToDouble(ring[from + QX + 3]);
    out.buttons = (int) ring[from + BUTTONS];
  }

  private int flags() {
    int flags = out.positionMm.isFinite() ? FLAG_NONE : FLAG_NOT_FINITE;
    flags |= out.timeNanos < lastTimeNanos ? FLAG_BACKWARD_TIME : FLAG_NONE;
    lastTimeNanos = out.timeNanos;
    return flags;
  }

  /** Samples that were lost because the ring was full. Any thread. */
  public long overflows() {
    return overflows.get();
  }

  /** Samples that were put in. Any thread. */
  public long recorded() {
    return written.get();
  }
}
