package org.palpate.scene.surface;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Queue;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Extracts surface bricks in the background, on threads of low priority so that the haptic thread
 * is not disturbed. Any thread may request bricks.
 *
 * <p>Edits and bricks that are built take turns while there are both. So an edit does not wait
 * until all is built, and a tool that cuts without a pause does not keep surfaces from being built.
 */
public final class SurfaceBuilder implements AutoCloseable {
  /** Receives bricks. Several threads of the builder call it at once. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Receives a brick; null if it has no triangles (any more).
     *
     * @param started order of the start among all extractions: of two meshes of a brick, the one
     *     that started later is newer, whichever arrives first
     */
    void accept(int brick, long started, SurfaceBrick mesh);
  }

  /** Keeps the bricks of a source. Several threads of the builder call it at once. */
  public interface Store extends Sink {
    /**
     * Returns the newest brick that was received, without triangles {@link SurfaceBrick#EMPTY};
     * nothing if none of this source was received.
     */
    Optional<SurfaceBrick> newest(int brick);
  }

  /** The kinds of work, the most urgent first. Edits and the others take turns. */
  public enum Kind {
    /** An edit at the finest level. */
    EDITED,
    /** An edit at a coarse level. */
    EDITED_COARSE,
    /** A brick of a coarse level. */
    COARSE,
    /** A brick of the finest level. */
    FINE;

    private boolean isEdit() {
      return this == EDITED || this == EDITED_COARSE;
    }
  }

  private final ThreadPoolExecutor threads;
  private final ThreadLocal<SurfaceExtractor> extractor =
      ThreadLocal.withInitial(SurfaceExtractor::new);
  private final TaskQueue tasks = new TaskQueue();
  private final AtomicLong starts = new AtomicLong();
  private final Map<WaitingEdits, Rebuild> waiting = new ConcurrentHashMap<>();

  /** Bricks whose first extraction has not begun. It will see all edits until then. */
  private final Set<Brick> unbuilt = Collections.synchronizedSet(new HashSet<>());

  /** Held while edits are extracted: of two patches of a brick the second needs the first. */
  private final Object patching = new Object();

  /**
   * Bricks that lack an edit because its extraction failed. The next edit of such a brick extracts
   * it as a whole. Only used under {@link #patching}.
   */
  private final Set<Brick> outdated = new HashSet<>();

  /**
   * Creates a builder.
   *
   * @param threadCount number of threads, at least 1
   */
  public SurfaceBuilder(int threadCount) {
    AtomicInteger number = new AtomicInteger();
    threads =
        new ThreadPoolExecutor(
            threadCount,
            threadCount,
            0,
            TimeUnit.SECONDS,
            new LinkedBlockingQueue<>(),
            work -> thread(work, number.incrementAndGet()));
  }

  // Correctness does not depend on the priority; it only reduces the load if the system heeds it.
  @SuppressWarnings("ThreadPriorityCheck")
  private static Thread thread(Runnable work, int number) {
    Thread thread = new Thread(work, "palpate-surface-" + number);
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
    return thread;
  }

  /**
   * Extracts every brick of a source. {@code whenDone} runs after the last one if none failed.
   *
   * @return the job, which reports progress and failures
   */
  public SurfaceJob build(
      SurfaceSource source, AmbientOcclusion occlusion, Kind kind, Sink sink, Runnable whenDone) {
    int count = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE).count();
    SurfaceJob job = new SurfaceJob(count, whenDone);
    for (int n = 0; n < count; n++) {
      Brick brick = new Brick(source.bits(), n);
      unbuilt.add(brick);
      execute(
          kind,
          () -> {
            unbuilt.remove(brick); // also if the job has failed and leaves it to the next edit
            job.run(() -> extract(source, occlusion, brick.number, sink));
          });
    }
    return job;
  }

  /**
   * Extracts the cells of a source that an edit touches again, and patches their bricks. Edits that
   * come before the extraction has begun are extracted together, from the voxels at that time. So
   * the queue stays short even if edits come faster than the extraction.
   *
   * @param voxels a box around the edited voxels, copied
   * @param store the bricks; those that it does not have, or that lack an edit because an
   *     extraction failed, are extracted as a whole, unless they wait to be built
   * @return the job, which reports progress and failures
   */
  public SurfaceJob rebuild(
      SurfaceSource source,
      AmbientOcclusion occlusion,
      Kind kind,
      IntBox voxels,
      Store store,
      Runnable whenDone) {
    SurfaceJob job = new SurfaceJob(1, whenDone);
    WaitingEdits key = new WaitingEdits(source.bits(), kind);
    Rebuild fresh = new Rebuild(key, edited -> patch(source, occlusion, edited, store));
    Rebuild found =
        waiting.compute(key, (same, old) -> old != null && old.join(job, voxels) ? old : fresh);
    if (found == fresh) {
      fresh.join(job, voxels);
      execute(kind, fresh);
    }
    return job;
  }

  /** A brick of a cube. Cubes are equal only to themselves. */
  private record Brick(BitCube bits, int number) {}

  /** Edits that wait to be extracted. */
  private record WaitingEdits(BitCube bits, Kind kind) {}

  /** The extraction of edits for every job that asked for it before it began. */
  private final class Rebuild implements Runnable {
    private final WaitingEdits key;
    private final Consumer<IntBox> work;
    private final IntBox edited = new IntBox();
    private final List<SurfaceJob> jobs = new ArrayList<>();
    private boolean hasBegun;

    Rebuild(WaitingEdits key, Consumer<IntBox> work) {
      this.key = key;
      this.work = work;
    }

    /** Adds a job, unless the extraction has begun; returns whether it was added. */
    synchronized boolean join(SurfaceJob job, IntBox voxels) {
      if (!hasBegun) {
        edited.include(voxels);
        jobs.add(job);
      }
      return !hasBegun;
    }

    private synchronized void begin() {
      hasBegun = true;
    }

    @Override
    public void run() {
      begin();
      waiting.remove(key, this);
      SurfaceJob first = jobs.get(0);
      first.run(() -> work.accept(edited));
      jobs.subList(1, jobs.size()).forEach(job -> job.endLike(first));
    }
  }

  private void patch(SurfaceSource source, AmbientOcclusion occlusion, IntBox edited, Store store) {
    IntBox touched = SurfaceExtractor.touchedCells(source, edited, new IntBox());
    List<IntBox> parts = BrickLayout.parts(touched, SurfaceExtractor.BRICK_EDGE);
    synchronized (patching) {
      try {
        parts.forEach(part -> patchPart(source, occlusion, part, store));
      } catch (RuntimeException | Error cause) {
        parts.forEach(part -> outdated.addAll(bricksOf(source, part)));
        throw cause;
      }
    }
  }

  private static List<Brick> bricksOf(SurfaceSource source, IntBox cells) {
    BrickLayout layout = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE);
    return Arrays.stream(layout.bricksOf(cells))
        .mapToObj(number -> new Brick(source.bits(), number))
        .toList();
  }

  private void patchPart(
      SurfaceSource source, AmbientOcclusion occlusion, IntBox part, Store store) {
    BrickLayout layout = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE);
    List<Integer> known = new ArrayList<>();
    for (Brick brick : bricksOf(source, part)) {
      if (store.newest(brick.number).isPresent() && !outdated.contains(brick)) {
        known.add(brick.number);
      } else if (!unbuilt.contains(brick)) {
        extract(source, occlusion, brick.number, store);
        outdated.remove(brick);
      }
    }
    if (!known.isEmpty()) {
      long started = starts.getAndIncrement();
      Optional<SurfaceBrick> mesh =
          Optional.ofNullable(extractor.get().extract(source, occlusion, part));
      BrickPatch patch = new BrickPatch(source.bits(), part, mesh.orElse(SurfaceBrick.EMPTY));
      for (int brick : known) {
        IntBox cells = layout.cellsOf(brick, new IntBox());
        store
            .newest(brick)
            .ifPresent(old -> store.accept(brick, started, patch.appliedTo(old, cells)));
      }
    }
  }

  private void extract(SurfaceSource source, AmbientOcclusion occlusion, int brick, Sink sink) {
    long started = starts.getAndIncrement();
    sink.accept(brick, started, extractor.get().extract(source, occlusion, brick));
  }

  /**
   * Drops waiting bricks, so that their jobs are never done. Bricks in progress are finished and
   * given to their sinks.
   */
  @Override
  public void close() {
    threads.shutdownNow();
  }

  private void execute(Kind kind, Runnable work) {
    tasks.add(kind, work);
    threads.execute(() -> tasks.take().run());
  }

  /** The tasks that wait. Of edits and others, it gives one in turn if there are both. */
  private static final class TaskQueue {
    private final Queue<Task> edits = new PriorityQueue<>();
    private final Queue<Task> others = new PriorityQueue<>();
    private long count;
    private boolean lastWasEdit;

    synchronized void add(Kind kind, Runnable work) {
      (kind.isEdit() ? edits : others).add(new Task(kind, count++, work));
    }

    /** Removes a task; there must be one. */
    synchronized Runnable take() {
      lastWasEdit = others.isEmpty() || (!edits.isEmpty() && !lastWasEdit);
      return (lastWasEdit ? edits : others).remove().work;
    }
  }

  private record Task(Kind kind, long order, Runnable work) implements Comparable<Task> {
    @Override
    public int compareTo(Task other) {
      int byKind = kind.compareTo(other.kind);
      return byKind != 0 ? byKind : Long.compare(order, other.order);
    }
  }
}
