package org.palpate.scene.surface;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.palpate.volume.BitCube;

/**
 * Extracts surface bricks in the background, on threads of low priority so that the haptic thread
 * is not disturbed. Any thread may request bricks.
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

  /** Urgency of a brick that was edited and is visible. */
  public static final int EDITED = 0;

  /** Urgency of the first coarse picture. */
  public static final int COARSE = 1;

  /** Urgency of everything else. */
  public static final int FINE = 2;

  private final ThreadPoolExecutor threads;
  private final ThreadLocal<SurfaceExtractor> extractor =
      ThreadLocal.withInitial(SurfaceExtractor::new);
  private final AtomicLong order = new AtomicLong();
  private final AtomicLong starts = new AtomicLong();
  private final Map<WaitingBrick, Rebuild> waiting = new ConcurrentHashMap<>();

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
            new PriorityBlockingQueue<>(),
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
      SurfaceSource source, AmbientOcclusion occlusion, int urgency, Sink sink, Runnable whenDone) {
    int count = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE).count();
    SurfaceJob job = new SurfaceJob(count, whenDone);
    for (int n = 0; n < count; n++) {
      int brick = n;
      threads.execute(
          new BrickTask(
              urgency,
              order.getAndIncrement(),
              () -> job.run(() -> extract(source, occlusion, brick, sink))));
    }
    return job;
  }

  /**
   * Extracts some bricks of a source again after an edit. A brick that already waits is not queued
   * twice: it is extracted once for all its jobs, from the voxels at that time. So the queue stays
   * short even if edits come faster than the extraction.
   *
   * @return the job, which reports progress and failures
   */
  public SurfaceJob rebuild(
      SurfaceSource source,
      AmbientOcclusion occlusion,
      int urgency,
      int[] bricks,
      Sink sink,
      Runnable whenDone) {
    SurfaceJob job = new SurfaceJob(bricks.length, whenDone);
    for (int brick : bricks) {
      WaitingBrick key = new WaitingBrick(source.bits(), urgency, brick);
      Rebuild fresh = new Rebuild(key, () -> extract(source, occlusion, brick, sink));
      Rebuild found =
          waiting.compute(key, (same, old) -> old != null && old.join(job) ? old : fresh);
      if (found == fresh) {
        fresh.join(job);
        threads.execute(new BrickTask(urgency, order.getAndIncrement(), fresh));
      }
    }
    return job;
  }

  /** A brick that waits to be extracted again. Cubes are equal only to themselves. */
  private record WaitingBrick(BitCube bits, int urgency, int brick) {}

  /** The extraction of a brick for every job that asked for it before it began. */
  private final class Rebuild implements Runnable {
    private final WaitingBrick key;
    private final Runnable work;
    private final List<SurfaceJob> jobs = new ArrayList<>();
    private boolean hasBegun;

    Rebuild(WaitingBrick key, Runnable work) {
      this.key = key;
      this.work = work;
    }

    /** Adds a job, unless the extraction has begun; returns whether it was added. */
    synchronized boolean join(SurfaceJob job) {
      if (!hasBegun) {
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
      first.run(work);
      jobs.subList(1, jobs.size()).forEach(job -> job.endLike(first));
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

  private record BrickTask(int urgency, long order, Runnable work)
      implements Runnable, Comparable<BrickTask> {
    @Override
    public void run() {
      work.run();
    }

    @Override
    public int compareTo(BrickTask other) {
      int byUrgency = Integer.compare(urgency, other.urgency);
      return byUrgency != 0 ? byUrgency : Long.compare(order, other.order);
    }
  }
}
