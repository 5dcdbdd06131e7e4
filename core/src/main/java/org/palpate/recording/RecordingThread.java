package org.palpate.recording;

import java.util.concurrent.locks.LockSupport;

/**
 * Drains a {@link SampleRecorder} into a sink in a thread of its own, some twenty times a second,
 * until it is closed.
 *
 * <pre>
 *   SampleRecorder recorder = new SampleRecorder();
 *   try (RecordingThread thread = RecordingThread.start(recorder, new TrajectoryWriter(file, text))) {
 *     ... a session over new RecordingDevice(device, recorder) ...
 *   }   // everything that was recorded is in the file; a failure to write is thrown here
 * </pre>
 */
public final class RecordingThread implements AutoCloseable {
  private static final long PAUSE_NANOS = 50_000_000;

  private final SampleRecorder recorder;
  private final SampleRecorder.Sink sink;
  private final Thread thread = new Thread(this::drainUntilEnded, "palpate-recorder");
  private volatile boolean ended;
  private volatile RuntimeException failure;

  private RecordingThread(SampleRecorder recorder, SampleRecorder.Sink sink) {
    this.recorder = recorder;
    this.sink = sink;
  }

  /** Starts draining. */
  public static RecordingThread start(SampleRecorder recorder, SampleRecorder.Sink sink) {
    RecordingThread recording = new RecordingThread(recorder, sink);
    recording.thread.setDaemon(true);
    recording.thread.start();
    return recording;
  }

  private void drainUntilEnded() {
    try {
      while (!ended) {
        recorder.drainTo(sink);
        LockSupport.parkNanos(this, PAUSE_NANOS);
      }
      recorder.drainTo(sink);
    } catch (RuntimeException e) {
      failure = e;
    }
  }

  /** What the sink threw, after which nothing more is written; null where all is well. */
  public RuntimeException failure() {
    return failure;
  }

  /**
   * Drains the rest and ends the thread. Call it after the session's last frame.
   *
   * @throws RuntimeException what the sink threw, now or before
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
