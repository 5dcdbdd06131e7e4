package org.palpate.assess;

import java.util.List;
import java.util.Set;
import org.HdrHistogram.Histogram;
import org.palpate.frame.FrameObserver;
import org.palpate.frame.FrameRecord;

/**
 * Assesses a session from what its frames did. It reads no clock: times are those of the samples,
 * so a session and its replay are assessed alike.
 *
 * <pre>
 *   SessionAssessor assessor = new SessionAssessor(segments, Set.of(nerve));
 *   frame.observe(assessor);      // or a FrameRecorder of package recording, and drain it
 *   ... frames ...
 *   assessor.finish();
 * </pre>
 *
 * <p>One thread. Allocates only if the hand lets go of a body; a live session gives it the frames
 * through a {@code FrameRecorder} all the same, because a row of the spectrum takes a millisecond.
 */
public final class SessionAssessor implements FrameObserver {
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double MILLI = 1e3;
  private static final double MICRO = 1e6;
  private static final long MOST_MILLINEWTON = 1_000_000_000;

  /** A longer pause between two samples counts as this long. */
  private static final double LONGEST_SECONDS = 1;

  private final ContactStatistics[] objects;
  private final boolean[] isForbidden;
  private final ContactStatistics whole = new ContactStatistics();
  private final Histogram milliNewton = new Histogram(MOST_MILLINEWTON, 3);
  private final TremorSpectrum tremor = new TremorSpectrum();
  private final SteadyPath hand = new SteadyPath(tremor::add);
  private final SteadyPath tool = new SteadyPath(SteadyPath.Sink.NONE);
  private final SessionCourse course = new SessionCourse();
  private final HoldRecorder holds = new HoldRecorder();
  private long frames;
  private long freed;
  private long firstNanos;
  private double seconds;
  private int heldBody = -1;
  private int lastObject = -1;

  /**
   * Creates an assessor of no frame.
   *
   * @param objects the number of objects in the scene
   * @param forbidden the indices of those that the tool must not touch
   */
  public SessionAssessor(int objects, Set<Integer> forbidden) {
    this.objects = new ContactStatistics[objects];
    isForbidden = new boolean[objects];
    for (int n = 0; n < objects; n++) {
      this.objects[n] = new ContactStatistics();
      isForbidden[n] = forbidden.contains(n);
    }
  }

  /** Adds a frame. */
  @Override
  public void accept(FrameRecord frame) {
    if (frames == 0) {
      firstNanos = frame.timeNanos;
    }
    double now = Math.max(seconds, (frame.timeNanos - firstNanos) / NANOS_PER_SECOND);
    double elapsed = Math.min(now - seconds, LONGEST_SECONDS);
    seconds = now;
    frames++;
    freed += frame.freed ? 1 : 0;
    addContacts(frame, elapsed);
    addPaths(frame);
    holds.add(frame, seconds);
    course.add(frame, seconds, touchesForbidden());
  }

  private void addContacts(FrameRecord frame, double elapsed) {
    for (ContactStatistics object : objects) {
      object.begin();
    }
    whole.begin();
    if (frame.contact) {
      share(frame);
      whole.add(1);
      long micros = Math.max(1, Math.round(elapsed * MICRO));
      milliNewton.recordValueWithCount(milliNewton(frame), micros);
    } else {
      lastObject = -1;
    }
    for (ContactStatistics object : objects) {
      object.end(frame, seconds, elapsed);
    }
    whole.end(frame, seconds, elapsed);
  }

  private static long milliNewton(FrameRecord frame) {
    return Math.round(Math.min(MOST_MILLINEWTON, frame.pressingNewton * MILLI));
  }

  /**
   * Shares a contact among the touched objects. A point above an isosurface may press where no
   * voxel is in the way; the object that it touched last then counts.
   */
  private void share(FrameRecord frame) {
    for (int n = 0; n < frame.contacts(); n++) {
      lastObject = frame.object(n);
      objects[lastObject].add(frame.share(n));
    }
    if (frame.contacts() == 0 && lastObject >= 0) {
      objects[lastObject].add(1);
    }
  }

  private boolean touchesForbidden() {
    boolean touches = false;
    for (int n = 0; n < objects.length; n++) {
      touches |= isForbidden[n] && objects[n].isTouching();
    }
    return touches;
  }

  private void addPaths(FrameRecord frame) {
    if (frame.relocated) {
      hand.endPiece();
    }
    if (frame.relocated || frame.freed || frame.heldBody != heldBody) {
      tool.endPiece();
    }
    heldBody = frame.heldBody;
    hand.add(seconds, frame.deviceMm);
    tool.add(seconds, frame.tool.translation);
  }

  /** Ends paths and holds after the last frame. */
  public void finish() {
    hand.endPiece();
    tool.endPiece();
    holds.end();
  }

  /** {@return the number of frames that followed a new sample} */
  public long frames() {
    return frames;
  }

  /** {@return how often the tool was set free} */
  public long freed() {
    return freed;
  }

  /** {@return the time from the first frame to the last, s} */
  public double seconds() {
    return seconds;
  }

  /** {@return the length of the path of the device, mm; complete after {@link #finish}} */
  public double handPathMm() {
    return hand.lengthMm();
  }

  /**
   * {@return the length of the path of the tool, or of what the hand held, mm; complete after
   * {@link #finish}}
   */
  public double toolPathMm() {
    return tool.lengthMm();
  }

  /** {@return all contacts together} */
  public ContactStatistics contacts() {
    return whole;
  }

  /**
   * {@return the contacts with an object}
   *
   * @param object the index of the object in the scene
   */
  public ContactStatistics contacts(int object) {
    return objects[object];
  }

  /**
   * {@return the force that the hand exceeded in a part of the time in contact, N; 0 without
   * contact}
   *
   * @param part the part of the time in contact, from 0 to 1
   */
  public double exceededNewton(double part) {
    // The histogram gives the upper end of a class, which may lie above the largest force.
    double newton = milliNewton.getValueAtPercentile(100 * (1 - part)) / MILLI;
    return Math.min(newton, contacts().largestNewton());
  }

  /** {@return the spectrum of the hand's motion} */
  public TremorSpectrum tremor() {
    return tremor;
  }

  /** {@return the course of force and position} */
  public SessionCourse course() {
    return course;
  }

  /** {@return which bodies the hand held, in their order; complete after {@link #finish}} */
  public List<Hold> holds() {
    return holds.holds();
  }
}
