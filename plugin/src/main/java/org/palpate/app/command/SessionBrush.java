package org.palpate.app.command;

import java.util.Optional;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.palpate.app.options.BrushOptions;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.BrushPath;
import org.palpate.edit.DifferenceEdit;
import org.palpate.edit.Edit;
import org.palpate.edit.ShapeEdit;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentRepair;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.Smoothing;

/**
 * Corrects a segment of a live session with a brush: adds and erases voxels while the hand moves,
 * and removes islands, fills holes and smooths on demand. It queues edits, which the haptic thread
 * applies. Any thread, except for {@link #tick}.
 */
final class SessionBrush {
  /** The radius of the ball that smooths, as a fraction of the radius of the brush. */
  private static final double SMOOTHING_FRACTION = 0.25;

  /** The volume of a ball of radius 1. */
  private static final double BALL_VOLUME = 4 * Math.PI / 3;

  private final BrushOptions.Brush brush;
  private final TouchSession session;
  private final BitCube bits;
  private final GridMetric metric;
  private final Optional<RigidTool> tool;
  private final double radiusMm;
  private final AtomicBoolean isCorrecting = new AtomicBoolean();
  private volatile Optional<Stroke> stroke = Optional.empty();

  /** The stroke of the last edit; {@link #tick} alone uses it. */
  private Optional<Stroke> ticked = Optional.empty();

  /** The last edit of a stroke; {@link #tick} alone uses it. */
  private Optional<Edit> last = Optional.empty();

  /** A stroke that goes on until a key ends it. */
  private record Stroke(boolean adds, BrushPath path) {}

  /**
   * Creates the brush of a session.
   *
   * @param volume the segments that the session changes
   * @param tool the rigid tool of the session; empty for a point
   */
  SessionBrush(
      BrushOptions.Brush brush,
      TouchSession session,
      SegmentedVolume volume,
      Optional<RigidTool> tool) {
    this.brush = brush;
    this.session = session;
    this.tool = tool;
    bits = volume.segments().get(brush.segment()).bits();
    metric = volume.grid().metric();
    radiusMm = brush.radiusMm().orElseGet(() -> solidRadiusMm(tool.orElseThrow()));
    brush.start().ifPresent(paint -> toggle(paint == BrushOptions.Paint.ADD));
  }

  /**
   * Returns the distance from the reference point within which the solid of a covered tool lies,
   * mm.
   */
  private static double solidRadiusMm(RigidTool tool) {
    return tool.radiusMm() + tool.coverRadiusMm();
  }

  /** Adds the keys to the window of a view before it opens. */
  void addKeys(ConsoleViewListener listener, SessionView view) {
    listener.addKeys(input -> addKeys(input, view::proxyGrid, listener::print));
  }

  /**
   * Adds the keys.
   *
   * @param pointGrid gives the interaction point, grid coordinates; NaN before the first frame
   * @param out receives a line for each refusal
   */
  void addKeys(WindowInput input, Supplier<Vec3> pointGrid, Consumer<String> out) {
    input.onKey('a', "brush: begin or end to add voxels", () -> toggle(true));
    input.onKey('q', "brush: begin or end to erase voxels", () -> toggle(false));
    input.onKey(
        '5',
        "brush: remove islands smaller than it",
        () -> correct(before -> SegmentRepair.withoutIslands(before, ballVoxels()), out));
    input.onKey(
        '6',
        "brush: fill holes smaller than it",
        () -> correct(before -> SegmentRepair.withoutHoles(before, ballVoxels()), out));
    input.onKey(
        '7', "brush: smooth here", () -> correct(before -> smoothed(before, pointGrid.get()), out));
    input.onKey('e', "undo the last change", session::undo);
    input.onKey('y', "redo the last change", session::redo);
  }

  /** Begins a stroke, or ends the one of this kind. */
  private void toggle(boolean adds) {
    boolean ends = stroke.isPresent() && stroke.get().adds == adds;
    stroke = ends ? Optional.empty() : Optional.of(new Stroke(adds, new BrushPath()));
  }

  /**
   * Paints where the tool went since the last edit, unless that one is not complete yet. So at most
   * one waits, however large the brush is. Call it about 30 times a second.
   */
  void tick() {
    Optional<Stroke> now = stroke;
    if (now.isEmpty() || last.filter(edit -> !edit.isDone()).isPresent()) {
      return;
    }
    Edit edit = edit(now.get());
    if (now.equals(ticked)) {
      edit.continueStroke();
    }
    if (session.offer(edit)) {
      ticked = now;
      last = Optional.of(edit);
    }
  }

  private Edit edit(Stroke present) {
    return brush.radiusMm().isPresent()
        ? BrushEdit.atTool(brush.segment(), present.path, radiusMm, present.adds, brush.limits())
        : new ShapeEdit(
            brush.segment(),
            tool.orElseThrow().solid()::contains,
            radiusMm,
            present.adds,
            brush.limits());
  }

  private long ballVoxels() {
    double voxelMm3 = metric.spacingX() * metric.spacingY() * metric.spacingZ();
    return (long) Math.ceil(BALL_VOLUME * radiusMm * radiusMm * radiusMm / voxelMm3);
  }

  /** Computes a correction of the segment in the background, and queues what it changes. */
  private void correct(UnaryOperator<BitCube> correction, Consumer<String> out) {
    if (!isCorrecting.compareAndSet(false, true)) {
      out.accept("brush: the last correction is not complete yet");
      return;
    }
    Thread thread = new Thread(() -> correctNow(correction, out), "palpate-correct");
    thread.setDaemon(true);
    thread.start();
  }

  private void correctNow(UnaryOperator<BitCube> correction, Consumer<String> out) {
    try {
      BitCube before = bits.copy();
      DifferenceEdit edit =
          new DifferenceEdit(brush.segment(), before, correction.apply(before), brush.limits());
      if (edit.isEmpty()) {
        out.accept("brush: there is nothing to correct");
      } else if (!session.offer(edit)) {
        out.accept("brush: too many changes are waiting; try again");
      }
    } finally {
      isCorrecting.set(false);
    }
  }

  /** Returns a copy that is smooth within the brush, which is grown by the size of the tool. */
  private BitCube smoothed(BitCube before, Vec3 centreGrid) {
    double elementMm = Math.max(metric.shortestEdgeMm(), SMOOTHING_FRACTION * radiusMm);
    double toolMm = tool.map(RigidTool::radiusMm).orElse(0.0);
    return centreGrid.isFinite()
        ? new Smoothing(metric, elementMm).smoothed(before, centreGrid, radiusMm + toolMm)
        : before;
  }
}
