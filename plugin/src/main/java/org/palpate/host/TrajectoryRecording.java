package org.palpate.host;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;
import org.palpate.recording.RecordingThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;

/**
 * Records what a device sends into a trajectory file that can be replayed.
 *
 * <p>Opened, finished and closed by one thread at a time. A thread of its own takes the samples
 * from the haptic thread and writes them.
 */
public final class TrajectoryRecording implements AutoCloseable {
  private final Path target;
  private final AtomicFile file;
  private final Writer writer;
  private final SampleRecorder recorder = new SampleRecorder();
  private final RecordingThread thread;

  /** Written by the recording thread alone. */
  private volatile boolean holdsSamples;

  /**
   * Starts a recording.
   *
   * @throws IOException if the file cannot be created
   */
  public TrajectoryRecording(Path target) throws IOException {
    this.target = target;
    file = new AtomicFile(target);
    writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    TrajectoryWriter rows = new TrajectoryWriter(writer, NumberText::text);
    thread =
        RecordingThread.start(
            recorder,
            (sample, flags) -> {
              holdsSamples = true;
              rows.accept(sample, flags);
            });
  }

  /** Returns why the recording cannot be written, as far as is known. Any thread. */
  public Optional<IOException> failure() {
    return thread.failure() instanceof UncheckedIOException e
        ? Optional.of(e.getCause())
        : Optional.empty();
  }

  /** Returns the file that the recording replaces when it is finished. */
  public Path target() {
    return target;
  }

  /** Returns the recorder to give to a {@link TouchSession}. */
  public SampleRecorder recorder() {
    return recorder;
  }

  /**
   * Writes the remaining samples and moves the file over its target, unless there is no sample at
   * all. Call it after the session's last frame.
   *
   * @throws IOException if the file cannot be written
   */
  public void finish() throws IOException {
    try {
      thread.close();
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
    writer.flush();
    if (holdsSamples) {
      file.commit();
    }
  }

  /** Ends the recording; without {@link #finish} no file remains. May be called repeatedly. */
  @Override
  public void close() {
    try {
      closeBoth();
    } catch (IOException | UncheckedIOException e) {
      // The recording is given up; finish has reported the reason if the file was wanted.
    }
  }

  private void closeBoth() throws IOException {
    try {
      thread.close();
    } finally {
      file.close();
    }
  }
}
