package org.palpate.host.placing;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Supplier;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.RigidTransform;
import org.palpate.host.SessionView;
import org.palpate.volume.SegmentedVolume;

/**
 * Shows readings of the fragment in hand, or of the one that was touched last, in a view. A thread
 * of its own reads the poses that the view draws, so the haptic thread does no work for it.
 */
public final class LiveReadings implements AutoCloseable {
  private static final long PAUSE_NANOS = 100_000_000;
  private static final long JOIN_MILLIS = 1000;
  private static final int NONE = -1;

  private final ToolFrame frame;
  private final HeldReadings readings;
  private final SessionView view;
  private final GapColours colours;
  private final Supplier<List<String>> further;
  private final Thread thread = new Thread(this::run, "palpate-readings");
  private volatile boolean closed;
  private int body = NONE;
  private List<String> lines = List.of();

  /**
   * Creates readings that are not shown yet.
   *
   * @param frame knows the fragment in hand and the one that was touched last
   * @param readings computes the lines
   * @param fragments the fragments at rest
   * @param view shows them
   * @param further gives lines to show below, ten times a second
   */
  public LiveReadings(
      ToolFrame frame,
      HeldReadings readings,
      SegmentedVolume fragments,
      SessionView view,
      Supplier<List<String>> further) {
    this.frame = frame;
    colours = new GapColours(fragments, view);
    this.readings = readings;
    this.view = view;
    this.further = further;
    thread.setDaemon(true);
  }

  /** {@return the colours of the gap} */
  public GapColours colours() {
    return colours;
  }

  /** Starts to show readings. */
  public void start() {
    thread.start();
  }

  private void run() {
    List<RigidTransform> shown = List.of();
    while (!closed) {
      List<RigidTransform> poses = view.bodyPoses();
      int chosen = chosenBody();
      colours.update(chosen, poses, frame.groups());
      if (chosen != NONE && (chosen != body || !poses.equals(shown))) {
        body = chosen;
        lines = readings.lines(body, poses, frame.groups());
        shown = poses;
      }
      List<String> all = new ArrayList<>(lines);
      all.addAll(colours.lines());
      all.addAll(further.get());
      view.show(all);
      LockSupport.parkNanos(this, PAUSE_NANOS);
    }
  }

  private int chosenBody() {
    int present = frame.chosenBody();
    return present == NONE ? body : present;
  }

  /** Ends the readings, and waits at most a second for lines that are being computed. */
  @Override
  public void close() {
    closed = true;
    LockSupport.unpark(thread);
    try {
      thread.join(JOIN_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
