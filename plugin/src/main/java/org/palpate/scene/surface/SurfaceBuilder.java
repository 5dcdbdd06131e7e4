package org.palpate.scene.surface;

import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import java.util.stream.IntStream;

/**
 * Extracts bricks in the background, on threads of low priority so that the haptic thread is not
 * disturbed. Any thread may ask.
 */
public final class SurfaceBuilder implements AutoCloseable {
  /** Where bricks go, called from the builder's threads, several at once. */
  @FunctionalInterface
  public interface Sink {
    /**
     * Takes a brick; null where it has no triangles (any more).
     *
     * @param begun when it was begun, in an order of the builder's: of two meshes of a brick the
     *     one that was begun later is the newer, whichever comes first
     */
    void accept(int brick, long begun, SurfaceBrick mesh);
  }

  /** Urgency of a brick that was edited and is being looked at. */
  public static final int EDITED = 0;

  /** Urgency of the first coarse picture. */
  public static final int COARSE = 1;

  /** Urgency of the rest. */
  public static final int FINE = 2;

  private final ThreadPoolExecutor threads;
  private final ThreadLocal<SurfaceExtractor> extractor =
      ThreadLocal.withInitial(SurfaceExtractor::new);
  private final AtomicLong order = new AtomicLong();
  private final AtomicLong beginnings = new AtomicLong();

  /**
   * A builder with so many threads.
   *
   * @param threadCount at least 1
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

  // Nothing depends on the priority; where the system heeds it, the hand is disturbed less.
  @SuppressWarnings("ThreadPriorityCheck")
  private static Thread thread(Runnable work, int number) {
    Thread thread = new Thread(work, "palpate-surface-" + number);
    thread.setDaemon(true);
    thread.setPriority(Thread.MIN_PRIORITY);
    return thread;
  }

  /** Extracts every brick of a source; {@code whenDone} runs after the last, where none failed. */
  public SurfaceJob build(
      SurfaceSource source, AmbientOcclusion openness, int urgency, Sink sink, Runnable whenDone) {
    int count = BrickLayout.of(source.bits(), SurfaceExtractor.BRICK_EDGE).count();
    return build(source, openness, urgency, IntStream.range(0, count).toArray(), sink, whenDone);
  }

  /**
   * Extracts some bricks of a source, the more urgent ones before those already waiting.
   *
   * @return how far it is; a failure in the extraction or the sink is reported there
   */
  public SurfaceJob build(
      SurfaceSource source,
      AmbientOcclusion openness,
      int urgency,
      int[] bricks,
      Sink sink,
      Runnable whenDone) {
    SurfaceJob build = new SurfaceJob(bricks.length, whenDone);
    for (int brick : bricks) {
      threads.execute(
          new BrickTask(
              urgency,
              order.getAndIncrement(),
              () -> build.run(() -> extract(source, openness, brick, sink))));
    }
    return build;
  }

  private void extract(SurfaceSource source, AmbientOcclusion openness, int brick, Sink sink) {
    long begun = beginnings.getAndIncrement();
    sink.accept(brick, begun, extractor.get().extract(source, openness, brick));
  }

  /** Drops what waits; bricks in work are finished but no one is told. */
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
