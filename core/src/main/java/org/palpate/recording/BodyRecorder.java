package org.palpate.recording;

import java.util.function.LongSupplier;
import org.palpate.body.BodyEvent;
import org.palpate.body.BodyListener;
import org.palpate.geometry.Pose;

/**
 * A ring buffer of poses of bodies from the haptic thread to a file.
 *
 * <p>One writer, the haptic thread. One reader, a {@link RecordingThread}. A full buffer drops the
 * newest pose and counts it.
 */
public final class BodyRecorder {
  /** The number of events: most of a second in which eight bodies move in every frame at 10 kHz. */
  static final int CAPACITY = 1 << 16;

  private static final int BODY = 1;
  private static final int POSE = 2;
  private static final int IN_HAND = POSE + WordRing.WORDS_A_POSE;
  private static final int WORDS_AN_EVENT = IN_HAND + WordRing.WORDS_A_POSE;

  private final WordRing ring = new WordRing(CAPACITY, WORDS_AN_EVENT);
  private final BodyEvent[] events = new BodyEvent[CAPACITY];
  private final Pose pose = new Pose();
  private final Pose inHand = new Pose();

  /** Receives the recorded poses. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Receives an event; see {@link org.palpate.body.BodyListener#accept}.
     *
     * @param sample number of the device sample with which a replay repeats it, from 0
     * @param body the index of the body in the scene
     * @param event what happened to it
     * @param pose the body's pose as committed, from rest to present, world mm; not to be kept
     * @param inHand the pose of the body's reference point relative to the device; not to be kept
     */
    void accept(long sample, int body, BodyEvent event, Pose pose, Pose inHand);
  }

  /**
   * {@return a listener that adds each event} Its thread is that of {@link #offer}.
   *
   * @param sample the number of the device sample with which a replay repeats the present event
   */
  public BodyListener listener(LongSupplier sample) {
    return (body, event, pose, inHand) -> offer(sample.getAsLong(), body, event, pose, inHand);
  }

  /**
   * Adds an event; see {@link Sink#accept}. Haptic thread: never waits, allocates nothing.
   *
   * @param sample number of the device sample with which a replay repeats the event, from 0
   * @param body the index of the body in the scene
   * @param event what happened to it
   * @param newPose the body's pose as committed, from rest to present, world mm; copied
   * @param newInHand the pose of the body's reference point relative to the device; copied
   */
  public void offer(long sample, int body, BodyEvent event, Pose newPose, Pose newInHand) {
    int from = ring.claim();
    if (from == WordRing.FULL) {
      return;
    }
    ring.set(from, sample);
    ring.set(from + BODY, body);
    events[from / WORDS_AN_EVENT] = event;
    ring.set(from + POSE, newPose.translation, newPose.rotation);
    ring.set(from + IN_HAND, newInHand.translation, newInHand.rotation);
    ring.publish();
  }

  /**
   * Moves all events from the buffer into a sink. Reader.
   *
   * @param sink receives the events in the order in which they were added
   */
  public void drainTo(Sink sink) {
    for (int left = ring.available(); left > 0; left--) {
      int from = ring.oldest();
      ring.get(from + POSE, pose.translation, pose.rotation);
      ring.get(from + IN_HAND, inHand.translation, inHand.rotation);
      BodyEvent event = events[from / WORDS_AN_EVENT];
      sink.accept(ring.get(from), (int) ring.get(from + BODY), event, pose, inHand);
      ring.release();
    }
  }

  /** {@return the number of events that were dropped because the buffer was full} Any thread. */
  public long overflows() {
    return ring.overflows();
  }
}
