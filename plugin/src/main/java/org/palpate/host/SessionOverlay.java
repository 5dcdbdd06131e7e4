package org.palpate.host;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.palpate.device.HapticDevice;
import org.palpate.device.WorkspaceDevice;
import org.palpate.edit.HistoryEdit;
import org.palpate.geometry.Vec3;
import org.palpate.loop.LoopStatus;
import org.palpate.scene.ChangedVoxels;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.SegmentedVolume;

/**
 * The lines of text in the corner of a session's view. The synchronization thread updates them; any
 * thread invalidates them.
 */
final class SessionOverlay {
  private static final long UPDATE_NANOS = 500_000_000;

  /** Time for which a hint is shown. */
  private static final long HINT_NANOS = 4_000_000_000L;

  private final TouchSession session;
  private final HapticDevice device;
  private final Optional<MovableSlices> slices;
  private final Optional<LiveThreshold> threshold;
  private volatile boolean invalid;
  private volatile Hint hint = new Hint("", 0);
  private volatile String touched = "contact";
  private volatile String removedText = "";
  private volatile List<String> further = List.of();
  private List<String> lines = List.of();
  private final Vec3 lastMm = new Vec3(Double.NaN, Double.NaN, Double.NaN);
  private final Vec3 stepMm = new Vec3();

  /** The path of the tool since the last update, mm. */
  private double pathMm;

  private long updateNanos;
  private long lastFrames;
  private long lastApplications;
  private double lastProgress;
  private String lastTriangles = "";

  /** A line that is shown for a while. */
  private record Hint(String text, long sinceNanos) {}

  SessionOverlay(
      TouchSession session,
      HapticDevice device,
      Optional<MovableSlices> slices,
      Optional<LiveThreshold> threshold) {
    this.threshold = threshold;
    this.session = session;
    this.device = device;
    this.slices = slices;
  }

  /** Requests new lines at the next tick. */
  void invalidate() {
    invalid = true;
  }

  /** Shows a line for a few seconds; an empty one removes the last. */
  void hint(String text) {
    if (!text.isEmpty() || !hint.text.isEmpty()) {
      hint = new Hint(text, System.nanoTime());
      invalid = true;
    }
  }

  /** Shows further lines below the others. */
  void show(List<String> shown) {
    if (!shown.equals(further)) {
      further = List.copyOf(shown);
      invalid = true;
    }
  }

  /** Sets the name of the segment that is touched while there is contact. */
  void touches(Optional<String> segment) {
    touched = segment.orElse("contact");
  }

  /** Shows for each segment the volume that was removed or added. Synchronization thread. */
  void removed(ChangedVoxels changed, SegmentedVolume volume) {
    StringBuilder text = new StringBuilder();
    for (int n = 0; n < volume.segments().size(); n++) {
      Vec3 spacing = volume.grid(n).spacingMm();
      double mm3 = changed.removed(n) * spacing.x * spacing.y * spacing.z;
      if (mm3 != 0) {
        text.append(mm3 > 0 ? "   removed " : "   added ").append(volume.segments().get(n).name());
        text.append(format(" %.1f mm³", Math.abs(mm3)));
      }
    }
    removedText = text.toString();
  }

  /** Notes where the tool is, world mm, to measure its speed. Synchronization thread. */
  void follow(Vec3 toolMm) {
    double mm = toolMm.sub(lastMm, stepMm).length();
    pathMm += Double.isFinite(mm) ? mm : 0;
    lastMm.set(toolMm);
  }

  private void dropOldHint(long now) {
    Hint shown = hint;
    if (!shown.text.isEmpty() && now - shown.sinceNanos > HINT_NANOS) {
      hint("");
    }
  }

  /** Returns the hint, or else how to begin with the mouse. */
  private String hintLine() {
    String text = hint.text;
    if (!text.isEmpty()) {
      return text;
    }
    if (device instanceof MouseTakeover takeover && !takeover.mouse().hasJumped()) {
      return "drag on the surface to touch with the mouse";
    }
    return device instanceof MouseDevice mouse && !mouse.hasJumped()
        ? "press on the surface and drag to touch"
        : "";
  }

  /**
   * Returns new lines twice a second while something changes, otherwise the same lines, which cause
   * no redraw.
   *
   * @param applications number of ticks that applied a change
   * @param progress fraction of the surfaces that is complete
   * @param triangles text about the drawn triangles
   */
  List<String> update(long applications, double progress, String triangles) {
    long now = System.nanoTime();
    dropOldHint(now);
    boolean changed =
        applications != lastApplications
            || progress != lastProgress
            || !triangles.equals(lastTriangles);
    if (invalid || (changed && now - updateNanos >= UPDATE_NANOS)) {
      invalid = false;
      LoopStatus status = session.status();
      lines = lines(status, now, triangles + progressText(triangles, progress));
      pathMm = 0;
      updateNanos = now;
      lastFrames = status.frames();
      lastApplications = applications;
      lastProgress = progress;
      lastTriangles = triangles;
    }
    return lines;
  }

  private String rateText(LoopStatus status, long now) {
    return updateNanos == 0
        ? ""
        : format("%.0f Hz   ", (status.frames() - lastFrames) * 1e9 / (now - updateNanos));
  }

  /** Returns the feed of a tool that cuts: its mean speed since the last update. */
  private String feedText(long now) {
    return updateNanos == 0 ? "" : format("   feed %.0f mm/s", pathMm * 1e9 / (now - updateNanos));
  }

  private static String progressText(String triangles, double progress) {
    return triangles.isEmpty() || progress == 1
        ? ""
        : format("   surfaces %.0f %%", Math.floor(100 * progress));
  }

  private List<String> lines(LoopStatus status, long now, String surfaces) {
    List<String> all = new ArrayList<>();
    Collections.addAll(
        all,
        format("%slate %.0f µs", rateText(status, now), status.latestLatenessNanos() / 1e3),
        format("%.2f N   %s", status.forceNewton(), status.contact() ? touched : "free")
            + (session.cuts() ? feedText(now) : ""),
        removedText.strip(),
        tuningLine(),
        threshold.map(LiveThreshold::line).orElse(""),
        slices.map(MovableSlices::line).orElse(""),
        surfaces,
        "h: help",
        hintLine());
    all.addAll(further);
    return all;
  }

  private String tuningLine() {
    boolean clutched = device instanceof WorkspaceDevice mapped && mapped.isClutchRequested();
    return session.tuning().line() + (clutched ? "   clutch held" : "");
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }

  /**
   * The keys that undo and redo, and the lines that say why nothing happens. The window's thread
   * presses the keys; the synchronization thread reports what was refused.
   */
  static final class UndoKeys {
    private final TouchSession session;
    private final Consumer<String> hint;

    /** Requests that are not known to be done, the oldest first. */
    private final Queue<HistoryEdit> asked = new ConcurrentLinkedQueue<>();

    /**
     * Creates the keys of a session.
     *
     * @param hint shows a line to the user for a few seconds
     */
    UndoKeys(TouchSession session, Consumer<String> hint) {
      this.session = session;
      this.hint = hint;
    }

    /** Adds the keys to a window, if the session has something to undo. */
    void addTo(WindowInput input) {
      if (session.cuts() || session.canHold()) {
        input.onKey('e', "undo the last cut or placement", () -> ask(HistoryEdit.undo()));
        input.onKey('y', "redo the last cut or placement", () -> ask(HistoryEdit.redo()));
      }
    }

    private void ask(HistoryEdit edit) {
      String name = name(edit);
      if (!session.offer(edit)) {
        hint.accept("too many edits wait: " + name + " again later");
        return;
      }
      asked.add(edit);
      if (session.isHolding()) {
        hint.accept(name + " waits until you let go");
      }
    }

    /** Says what was refused since the last call. */
    void tick() {
      while (!asked.isEmpty() && asked.peek().isDone()) {
        HistoryEdit edit = asked.remove();
        if (edit.isRefused()) {
          hint.accept(name(edit) + " refused: a body has come there since");
        }
      }
    }

    private static String name(HistoryEdit edit) {
      return edit.isUndo() ? "undo" : "redo";
    }
  }
}
