package org.palpate.benchmarks.carve;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.concurrent.TimeoutException;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.DoubleStream;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.recording.EditRecorder;
import org.palpate.scene.ChangedVoxels;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.SynchronizationThread;
import org.palpate.scene.Theme;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.surface.SurfaceJob;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * Measures the time from a cut to the changed surface that is handed to the scene, while a burr
 * drills a thousand frames a second. Surfaces are built as the window of a session builds them.
 *
 * <p>A second of drilling comes first and has its own figure, because the program is not compiled
 * yet. A session has built the surfaces of its volume before its user drills.
 */
final class RemeshTimes {
  private static final long FRAME_NANOS = 1_000_000;
  private static final long POLL_NANOS = 250_000;
  private static final long PATIENCE_MILLIS = 60_000;
  private static final long PATIENCE_NANOS = PATIENCE_MILLIS * 1_000_000;
  private static final double NANOS_PER_MS = 1e6;
  private static final double TARGET_MS = 33;
  private static final int FIRST_FRAMES = 1_000;

  private final int frames;
  private final DrilledSlab slab = new DrilledSlab();
  private final EditRecorder changes = new EditRecorder();
  private final ChangedVoxels changed = new ChangedVoxels(1);

  /** The cuts since the last step and those whose surfaces are being built. */
  private List<Long> cuts = new ArrayList<>();

  private final Deque<Batch> building = new ArrayDeque<>();
  private final List<Double> millis = new ArrayList<>();

  /** Cuts whose surface one job builds. */
  private record Batch(List<Long> nanos, SurfaceJob job) {}

  private RemeshTimes(int frames) {
    this.frames = frames;
  }

  /** Drills twice, and returns the figures. */
  static List<RigidFigure> figures(int frames) {
    double[] first = new RemeshTimes(Math.min(frames, FIRST_FRAMES)).millis();
    double[] sample = new RemeshTimes(frames).millis();
    return List.of(
        figure("cut to surface p99, first second", Quantile.of(first, 0.99), Double.NaN),
        figure("cut to surface p50", Quantile.of(sample, 0.5), Double.NaN),
        figure("cut to surface p99", Quantile.of(sample, 0.99), TARGET_MS),
        figure("cut to surface, longest", DoubleStream.of(sample).max().orElse(0), Double.NaN),
        RigidFigure.of("surface", DrilledSlab.NAME, "voxels removed", (double) sample.length, ""));
  }

  /** Drills, and returns the time of each cut to its surface, ms. */
  private double[] millis() {
    SegmentedVolume volume =
        new SegmentedVolume(
            DrilledSlab.grid(), List.of(new Segment("bone", slab.bits(), 0xf0e0c0)));
    SceneModel model = new SceneModel(WorldAxes.UNKNOWN, Theme.DARK);
    try (SceneLoader loader = new SceneLoader(model, volume, 1)) {
      loader.await(PATIENCE_MILLIS);
      drill(loader);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } catch (TimeoutException e) {
      throw new IllegalStateException("the surfaces take more than a minute", e);
    }
    return millis.stream().mapToDouble(Double::doubleValue).toArray();
  }

  private static RigidFigure figure(String name, double millis, double target) {
    return new RigidFigure("surface", DrilledSlab.NAME, name, millis, "ms", target);
  }

  private void drill(SceneLoader loader) throws InterruptedException, TimeoutException {
    slab.listen(
        (segment, i, j, k, solid) -> changes.offer(System.nanoTime(), segment, i, j, k, solid));
    Thread haptic = new Thread(this::runFrames, "palpate-drill");
    haptic.start();
    try (SynchronizationThread steps =
        new SynchronizationThread(
            () -> {},
            () -> step(loader),
            failure -> {
              throw failure;
            })) {
      steps.start();
      while (haptic.isAlive()) {
        waitAndTakeFinished();
      }
      haptic.join();
      long latest = System.nanoTime() + PATIENCE_NANOS;
      while (!isBuilt()) {
        if (System.nanoTime() > latest) {
          throw new TimeoutException();
        }
        waitAndTakeFinished();
      }
    }
  }

  private void waitAndTakeFinished() {
    LockSupport.parkNanos(POLL_NANOS);
    takeFinished();
  }

  private void runFrames() {
    long due = System.nanoTime();
    for (int n = 0; n < frames; n++) {
      due += FRAME_NANOS;
      while (System.nanoTime() < due) {
        LockSupport.parkNanos(due - System.nanoTime());
      }
      slab.runFrame();
    }
  }

  private synchronized void step(SceneLoader loader) {
    changes.drainTo(
        (nanos, segment, i, j, k, solid) -> {
          cuts.add(nanos);
          changed.note(segment, i, j, k, solid);
        });
    List<SurfaceJob> jobs = new ArrayList<>();
    changed.remesh((segment, box) -> jobs.add(loader.remesh(segment, box).get(0)));
    for (SurfaceJob job : jobs) {
      building.add(new Batch(cuts, job));
      cuts = new ArrayList<>();
    }
  }

  private synchronized boolean isBuilt() {
    return building.isEmpty() && cuts.isEmpty() && millis.size() == slab.removed();
  }

  private synchronized void takeFinished() {
    long now = System.nanoTime();
    building.removeIf(
        batch -> {
          boolean isDone = batch.job.isDone();
          if (isDone) {
            batch.nanos.forEach(cut -> millis.add((now - cut) / NANOS_PER_MS));
          }
          return isDone;
        });
  }
}
