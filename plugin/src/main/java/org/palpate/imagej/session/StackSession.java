package org.palpate.imagej.session;

import ij.Executer;
import ij.IJ;
import ij.ImagePlus;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.palpate.elastic.PublishedShape;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.imagej.annotation.LandmarkButton;
import org.palpate.imagej.annotation.LandmarkTable;
import org.palpate.imagej.annotation.StrokeHistory;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.stack.PixelSnapshot;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.StackGreyValues;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackSynchronizer;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** A stack that is being touched. Other threads may add landmarks and brush strokes. */
public final class StackSession extends HandSession {
  /** Frames a second. */
  static final double RATE_HZ = 1000;

  private static final long UNDO_WAIT_SECONDS = 1;

  private final ImagePlus image;
  private final StackGeometry geometry;
  private final List<SegmentRange> ranges;
  private final List<Segment> segments;
  private final RealtimeThread realtime = StackRealtime.thread();
  private final LandmarkButton button;
  private final TouchSession session;
  private final StackSynchronizer synchronizer;
  private final Optional<SessionView> view;

  /** The shape of elastic segments, if there are any and no view reads it. */
  private final Optional<PublishedShape> shape;

  private final LandmarkTable landmarks;
  private final StrokeHistory strokes;

  /**
   * Builds the segments, opens the device and prepares the session.
   *
   * @param recorder records what the device sends, if given
   * @throws TouchRefusedException if the stack, the device or an option does not allow a session
   */
  StackSession(StackVolume volume, TouchOptions options, Optional<SampleRecorder> recorder)
      throws TouchRefusedException {
    super(StackGeometry.of(volume.image()), options.seconds());
    image = volume.image();
    geometry = StackGeometry.of(image);
    ranges = options.ranges(volume);
    IJ.showStatus("Palpate: making segments...");
    PixelSnapshot pixels = new PixelSnapshot(volume);
    segments =
        StackSegments.of(
            volume, pixels::slice, ranges, k -> IJ.showProgress(k + 1, volume.slices()));
    requireVoxels(options);
    options.materials().checkNamed(segments);
    ContactScene scene =
        new ContactScene(
            new SegmentedVolume(geometry.grid(), segments),
            options.contactSettings(),
            StackGreyValues.surface(pixels, volume.slices(), geometry.grid(), ranges));
    volume.logWarning(scene.settings().solver());
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ).with(realtime, realtime);
    StackDevice device =
        StackDevice.open(options.device(), scene, options.workspace(), loop.periodNanos());
    button = new LandmarkButton(device.device());
    session =
        new TouchSession(
            scene,
            button,
            SessionSettings.standard()
                .withDefaultStiffness(device.defaultNewtonPerMm())
                .withLoop(loop)
                .withElastic(options.materials().bodies(scene.volume()))
                .withRecorder(recorder));
    synchronizer =
        new StackSynchronizer(volume, pixels, ranges, options.followsThreshold(), scene, changes());
    strokes = new StrokeHistory(volume, geometry.grid().spacingMm());
    view =
        options.view() && GraphicsDriver.hasDisplay()
            ? Optional.of(newView(device))
            : Optional.empty();
    shape = view.isPresent() ? Optional.empty() : session.shape();
    landmarks =
        new LandmarkTable(
            image, geometry, all -> view.ifPresent(shown -> shown.showLandmarks(all)));
  }

  private SessionView newView(StackDevice device) {
    List<Segment> drawn = new ArrayList<>();
    List<BitCube> bits = synchronizer.mirrors();
    for (int n = 0; n < bits.size(); n++) {
      drawn.add(new Segment(segments.get(n).name(), bits.get(n), segments.get(n).rgb()));
    }
    return new SessionView(
        session,
        new SegmentedVolume(geometry.grid(), drawn),
        WorldAxes.UNKNOWN,
        device.device(),
        new ViewKeys(this));
  }

  private void requireVoxels(TouchOptions options) throws TouchRefusedException {
    long voxels = segments.stream().mapToLong(segment -> segment.bits().solidCount()).sum();
    if (voxels == 0) {
      throw new TouchRefusedException(
          "No voxel has a value from "
              + options.lower()
              + " to "
              + options.upper()
              + ": choose other thresholds.");
    }
  }

  @Override
  LoopEnd run() throws TouchRefusedException {
    StrokeUndo undo = new StrokeUndo(image, this::undoIfLast);
    Executer.addCommandListener(undo);
    LoopEnd end;
    try {
      end = super.run();
    } finally {
      Executer.removeCommandListener(undo);
    }
    if (session.endedByTrouble()) {
      throw new TouchRefusedException(
          "The session ended with zero force: " + session.elasticTrouble().orElseThrow() + ".");
    }
    return end;
  }

  @Override
  TouchSession session() {
    return session;
  }

  @Override
  public Optional<SessionView> view() {
    return view;
  }

  @Override
  void tick() throws TouchRefusedException {
    for (int n = button.pollPresses(); n > 0; n--) {
      queue(this::addLandmarkHere);
    }
    synchronizer.applyChanges();
  }

  @Override
  Vec3 takeUpdates() {
    session.takeUpdates();
    Vec3 atRest = new Vec3();
    return shape.isPresent()
        ? shape.get().materialPoint(atRest)
        : session.properties().touch().interactionPoint(atRest);
  }

  @Override
  boolean isImageClosed() {
    return synchronizer.isClosed();
  }

  private StackSynchronizer.Listener changes() {
    return new StackSynchronizer.Listener() {
      @Override
      public void updated() {
        wake();
      }

      @Override
      public void seen(int i, int j, int k, float value) {
        strokes.seen(i, j, k, value);
      }

      @Override
      public void changed(IntBox voxels, int segment) {
        view.ifPresent(shown -> shown.remesh(segment, voxels));
      }
    };
  }

  /** Adds the next landmark at the interaction point. */
  void addLandmarkHere() throws TouchRefusedException {
    landmarks.add(landmarks.nextName(), touchedPointGrid());
  }

  /** Returns the landmarks. */
  public LandmarkTable landmarks() {
    return landmarks;
  }

  /**
   * Paints a ball at the interaction point into the first segment.
   *
   * @return the number of changed voxels
   */
  public int paint(double radiusMm, boolean add) throws TouchRefusedException {
    int changed = strokes.paint(touchedPointGrid(), radiusMm, ranges.get(0), add);
    synchronizer.markUpdated();
    return changed;
  }

  /**
   * Undoes the last brush stroke.
   *
   * @return the number of changed voxels
   */
  public int undo() throws TouchRefusedException {
    int changed = strokes.undo();
    synchronizer.markUpdated();
    return changed;
  }

  /**
   * Undoes the last brush stroke, unless something else has changed the stack since. The thread of
   * the session does it. Any other thread; waits at most a second.
   *
   * @return whether a stroke was undone
   */
  boolean undoIfLast() {
    CompletableFuture<Boolean> undone = new CompletableFuture<>();
    queue(
        () -> {
          try {
            synchronizer.applyChanges(); // sees what was changed up to now
            boolean isLast = strokes.isStrokeLast();
            if (isLast) {
              undo();
            }
            undone.complete(isLast);
          } finally {
            undone.complete(false); // after a refusal; else it does nothing
          }
        });
    wake();
    return undone.completeOnTimeout(false, UNDO_WAIT_SECONDS, TimeUnit.SECONDS).join();
  }

  /**
   * Redoes the last undone brush stroke.
   *
   * @return the number of changed voxels
   */
  public int redo() throws TouchRefusedException {
    int changed = strokes.redo();
    synchronizer.markUpdated();
    return changed;
  }

  /** Returns the segments as they were built, with their voxels at the start. */
  public List<Segment> segments() {
    return segments;
  }

  /** Returns the number of voxels of a segment at the last tick. Any thread. */
  public long voxels(int segment) {
    return synchronizer.solidCount(segment);
  }

  @Override
  public void close() {
    synchronizer.close();
    super.close();
    realtime.close();
  }
}
