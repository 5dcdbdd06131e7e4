package org.palpate.app.output;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.palpate.app.options.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;
import org.palpate.recording.RecordingThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;

/** What a device sends, on its way into a file. Opened and closed by one thread. */
public final class TrajectoryRecording implements AutoCloseable {
  private final Path target;
  private final AtomicFile file;
  private final Writer writer;
  private final SampleRecorder recorder = new SampleRecorder();
  private final RecordingThread thread;

  /** Starts to record. */
  public TrajectoryRecording(Path target) throws IOException {
    this.target = target;
    file = new AtomicFile(target);
    writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    thread = RecordingThread.start(recorder, new TrajectoryWriter(writer, NumberText::text));
  }

  public SampleRecorder recorder() {
    return recorder;
  }

  /** Samples that did not fit because the disk was too slow. After {@link #finish}. */
  long lost() {
    return recorder.overflows();
  }

  /**
   * Ends the file and moves it over its target, after the session's last frame.
   *
   * @throws PalpateException exit code 1, where it could not be written
   */
  public void finish() {
    try {
      thread.close();
      writer.flush();
      file.commit();
    } catch (UncheckedIOException e) {
      throw OutputPaths.failed(target, e.getCause());
    } catch (IOException e) {
      throw OutputPaths.failed(target, e);
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
