package org.palpate.recording;

import java.util.concurrent.locks.LockSupport;

/**
 * Moves samples from a {@link SampleRecorder} into a sink, some twenty times a second, in a thread
 * of its own.
 *
 * <pre>
 *   SampleRecorder recorder = new SampleRecorder();
 *   try (RecordingThread thread = RecordingThread.start(recorder, new TrajectoryWriter(file, text))) {
 *     ... a session over new RecordingDevice(device, recorder) ...
 *   }   // close() writes all samples, and throws if the file could not be written
 * </pre>
 */
public final class RecordingThread implements AutoCloseable {
  private static final long PAUSE_NANOS = 50_000_000;

  private final SampleRecorder recorder;
  private final SampleRecorder.Sink sink;
  private final Runnable others;
  private final Thread thread = new Thread(this::writeUntilEnded, "palpate-recorder");
  private volatile boolean ended;
  private volatile RuntimeException failure;

  private RecordingThread(SampleRecorder recorder, SampleRecorder.Sink sink, Runnable others) {
    this.recorder = recorder;
    this.sink = sink;
    this.others = others;
  }

  /**
   * Starts a thread that writes samples.
   *
   * @param recorder holds the samples
   * @param sink receives them in the thread
   * @return the thread, which {@link #close} ends
   */
  public static RecordingThread start(SampleRecorder recorder, SampleRecorder.Sink sink) {
    return start(recorder, sink, () -> {});
  }

  /**
   * Starts a thread that writes samples, and also moves what other recorders hold.
   *
   * @param recorder holds the samples
   * @param sink receives them in the thread
   * @param others moves what the other recorders hold; runs in the thread, after the samples
   * @return the thread, which {@link #close} ends
   */
  public static RecordingThread start(
      SampleRecorder recorder, SampleRecorder.Sink sink, Runnable others) {
    RecordingThread recording = new RecordingThread(recorder, sink, others);
    recording.thread.setDaemon(true);
    recording.thread.start();
    return recording;
  }

  private void writeUntilEnded() {
    try {
      while (!ended) {
        recorder.drainTo(sink);
        others.run();
        LockSupport.parkNanos(this, PAUSE_NANOS);
      }
      recorder.drainTo(sink);
      others.run();
    } catch (RuntimeException e) {
      failure = e;
    }
  }

  /** {@return the exception that the sink threw and that ended the thread, or null} Any thread. */
  public RuntimeException failure() {
    return failure;
  }

  /**
   * Writes the remaining samples and ends the thread. Call it after the session's last frame.
   *
   * @throws RuntimeException the exception of the sink, now or before
   */
  @Override
  public void close() {
    ended = true;
    LockSupport.unpark(thread);
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
    if (failure != null) {
      throw failure;
    }
  }
}
