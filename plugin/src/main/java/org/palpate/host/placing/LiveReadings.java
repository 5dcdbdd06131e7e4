package org.palpate.host.placing;

import java.util.ArrayList;
import java.util.List;
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
  private static final int NONE = -1;

  private final ToolFrame frame;
  private final HeldReadings readings;
  private final SessionView view;
  private final GapColours colours;
  private final Supplier<List<String>> further;
  private final RepeatingThread thread =
      new RepeatingThread("palpate-readings", PAUSE_NANOS, this::show, () -> {});
  private int body = NONE;
  private List<String> lines = List.of();

  /** The poses for which the lines were computed. */
  private List<RigidTransform> read = List.of();

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
  }

  /** {@return the colours of the gap} */
  public GapColours colours() {
    return colours;
  }

  /** Starts to show readings. */
  public void start() {
    thread.start();
  }

  private void show() {
    List<RigidTransform> poses = view.bodyPoses();
    int chosen = chosenBody();
    colours.update(chosen, poses, frame.groups());
    if (chosen != NONE && (chosen != body || !poses.equals(read))) {
      body = chosen;
      lines = readings.lines(body, poses, frame.groups());
      read = poses;
    }
    List<String> all = new ArrayList<>();
    if (body != NONE) {
      all.add(readings.heading(body, frame.heldBody() == body));
    }
    all.addAll(lines);
    all.addAll(colours.lines());
    all.addAll(further.get());
    view.show(all);
  }

  private int chosenBody() {
    int present = frame.chosenBody();
    return present == NONE ? body : present;
  }

  /** Ends the readings, and waits at most a second for lines that are being computed. */
  @Override
  public void close() {
    thread.close();
  }
}
