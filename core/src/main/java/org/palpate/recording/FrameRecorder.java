package org.palpate.recording;

import org.palpate.frame.FrameObserver;
import org.palpate.frame.FrameRecord;

/**
 * A ring buffer of what frames did, from the haptic thread to a reader.
 *
 * <p>One writer, the haptic thread. One reader. Numbers arrive bit for bit. A full buffer drops the
 * newest frame and counts it.
 */
public final class FrameRecorder implements FrameObserver {
  /** The usual capacity: three seconds at 10 kHz, 8 MB. */
  static final int CAPACITY = 1 << 15;

  private static final int TIME = 0;
  private static final int STATE = 1;
  private static final int DEVICE = 2;
  private static final int TOOL = DEVICE + 3;
  private static final int FORCE = TOOL + WordRing.WORDS_A_POSE;
  private static final int PRESSING = FORCE + 3;
  private static final int CONTACTS = PRESSING + 1;
  private static final int WORDS_A_FRAME = CONTACTS + 2 * FrameRecord.MOST_CONTACTS;

  private static final long CONTACT = 1;
  private static final long FREED = 1 << 1;
  private static final long RELOCATED = 1 << 2;
  private static final int COUNT_SHIFT = 8;
  private static final long COUNT_MASK = 0xff;
  private static final int HELD_SHIFT = 32;

  private final WordRing ring;
  private final FrameRecord out = new FrameRecord();

  /** Makes an empty buffer of the usual capacity. */
  public FrameRecorder() {
    this(CAPACITY);
  }

  /** Makes an empty buffer for {@code capacity} frames, at least 1. */
  FrameRecorder(int capacity) {
    ring = new WordRing(capacity, WORDS_A_FRAME);
  }

  /** Adds a frame. Haptic thread: never waits, allocates nothing. */
  @Override
  public void accept(FrameRecord frame) {
    int from = ring.claim();
    if (from == WordRing.FULL) {
      return;
    }
    ring.set(from + TIME, frame.timeNanos);
    ring.set(from + STATE, state(frame));
    ring.set(from + DEVICE, frame.deviceMm);
    ring.set(from + TOOL, frame.tool.translation, frame.tool.rotation);
    ring.set(from + FORCE, frame.forceNewton);
    ring.set(from + PRESSING, Double.doubleToRawLongBits(frame.pressingNewton));
    for (int n = 0; n < frame.contacts(); n++) {
      ring.set(from + CONTACTS + 2 * n, frame.object(n));
      ring.set(from + CONTACTS + 2 * n + 1, Double.doubleToRawLongBits(frame.share(n)));
    }
    ring.publish();
  }

  private static long state(FrameRecord frame) {
    return (frame.contact ? CONTACT : 0)
        | (frame.freed ? FREED : 0)
        | (frame.relocated ? RELOCATED : 0)
        | (long) frame.contacts() << COUNT_SHIFT
        | (long) frame.heldBody << HELD_SHIFT;
  }

  /**
   * Moves all frames from the buffer to an observer. Reader.
   *
   * @param sink receives the frames in order; their record is overwritten after each call
   */
  public void drainTo(FrameObserver sink) {
    for (int left = ring.available(); left > 0; left--) {
      read(ring.oldest());
      sink.accept(out);
      ring.release();
    }
  }

  private void read(int from) {
    long state = ring.get(from + STATE);
    out.timeNanos = ring.get(from + TIME);
    out.contact = (state & CONTACT) != 0;
    out.freed = (state & FREED) != 0;
    out.relocated = (state & RELOCATED) != 0;
    out.heldBody = (int) (state >> HELD_SHIFT);
    ring.get(from + DEVICE, out.deviceMm);
    ring.get(from + TOOL, out.tool.translation, out.tool.rotation);
    ring.get(from + FORCE, out.forceNewton);
    out.pressingNewton = Double.longBitsToDouble(ring.get(from + PRESSING));
    out.clearContacts();
    int count = (int) (state >> COUNT_SHIFT & COUNT_MASK);
    for (int n = 0; n < count; n++) {
      double share = Double.longBitsToDouble(ring.get(from + CONTACTS + 2 * n + 1));
      out.addContact((int) ring.get(from + CONTACTS + 2 * n), share);
    }
  }

  /** {@return the number of frames that were dropped because the buffer was full} Any thread. */
  public long overflows() {
    return ring.overflows();
  }
}
