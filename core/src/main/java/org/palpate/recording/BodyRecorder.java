package org.palpate.recording;

import java.util.concurrent.atomic.AtomicLong;
import org.palpate.body.BodyEvent;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/**
 * A ring buffer of poses of bodies from the haptic thread to a file.
 *
 * <p>One writer, the haptic thread. One reader, a {@link RecordingThread}. A full buffer drops the
 * newest pose and counts it.
 */
public final class BodyRecorder {
  /** The usual capacity: over a second in which eight bodies move in every frame. */
  public static final int DEFAULT_CAPACITY = 1 << 14;

  private static final int POSE = 2;
  private static final int WORDS_A_POSE = 7;
  private static final int IN_HAND = POSE + WORDS_A_POSE;
  private static final int WORDS = IN_HAND + WORDS_A_POSE;

  private final long[] ring;
  private final BodyEvent[] events;
  private final int capacity;
  private final AtomicLong written = new AtomicLong();
  private final AtomicLong taken = new AtomicLong();
  private final AtomicLong overflows = new AtomicLong();
  private final Pose pose = new Pose();
  private final Pose inHand = new Pose();

  /** Receives the recorded poses. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Receives an event; see {@link org.palpate.body.BodyListener#accept}.
     *
     * @param sample number of the device sample with which a replay repeats it, from 0
     */
    void accept(long sample, int body, BodyEvent event, Pose pose, Pose inHand);
  }

  /** Makes an empty buffer of the usual capacity. */
  public BodyRecorder() {
    this(DEFAULT_CAPACITY);
  }

  /** Makes an empty buffer for {@code capacity} events, at least 1. */
  public BodyRecorder(int capacity) {
    this.capacity = capacity;
    ring = new long[Math.multiplyExact(capacity, WORDS)];
    events = new BodyEvent[capacity];
  }

  /** Adds an event; see {@link Sink#accept}. Haptic thread: never waits, allocates nothing. */
  public void offer(long sample, int body, BodyEvent event, Pose newPose, Pose newInHand) {
    long at = written.getPlain();
    if (at - taken.get() >= capacity) {
      overflows.lazySet(overflows.getPlain() + 1);
      return;
    }
    int from = (int) (at % capacity) * WORDS;
    ring[from] = sample;
    ring[from + 1] = body;
    events[(int) (at % capacity)] = event;
    put(newPose, from + POSE);
    put(newInHand, from + IN_HAND);
    written.setRelease(at + 1);
  }

  private void put(Pose source, int from) {
    Quaternion q = source.rotation;
    for (int axis = 0; axis < 3; axis++) {
      ring[from + axis] = Double.doubleToRawLongBits(source.translation.get(axis));
    }
    ring[from + 3] = Double.doubleToRawLongBits(q.w);
    ring[from + 4] = Double.doubleToRawLongBits(q.x);
    ring[from + 5] = Double.doubleToRawLongBits(q.y);
    ring[from + 6] = Double.doubleToRawLongBits(q.z);
  }

  /** Moves all events from the buffer into a sink. Reader. */
  public void drainTo(Sink sink) {
    long end = written.getAcquire();
    for (long at = taken.getPlain(); at < end; at++) {
      int from = (int) (at % capacity) * WORDS;
      get(from + POSE, pose);
      get(from + IN_HAND, inHand);
      sink.accept(ring[from], (int) ring[from + 1], events[(int) (at % capacity)], pose, inHand);
      taken.setRelease(at + 1);
    }
  }

  private void get(int from, Pose dest) {
    Vec3 translation = dest.translation;
    for (int axis = 0; axis < 3; axis++) {
      translation.set(axis, number(from + axis));
    }
    dest.rotation.set(number(from + 3), number(from + 4), number(from + 5), number(from + 6));
  }

  private double number(int at) {
    return Double.longBitsToDouble(ring[at]);
  }

  /** Returns the number of events that were dropped because the buffer was full. Any thread. */
  public long overflows() {
    return overflows.get();
  }
}
