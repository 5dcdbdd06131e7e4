package org.palpate.app;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.palpate.interaction.FrameRecorder;
import org.palpate.interaction.RecordingThread;
import org.palpate.interaction.TrajectoryText;
import org.palpate.io.CsvNumbers;
import org.palpate.io.NewFile;

/** What a device sends, on its way into a file. Opened and closed by one thread. */
final class Recording implements AutoCloseable {
  private final Path target;
  private final NewFile file;
  private final Writer writer;
  private final FrameRecorder recorder = new FrameRecorder();
  private final RecordingThread thread;

  /** Starts to record. */
  Recording(Path target) throws IOException {
    this.target = target;
    file = new NewFile(target);
    writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    thread = RecordingThread.start(recorder, new TrajectoryText(writer, CsvNumbers::text));
  }

  FrameRecorder recorder() {
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
  void finish() {
    try {
      thread.close();
      writer.flush();
      file.commit();
    } catch (UncheckedIOException e) {
      throw Outputs.failed(target, e.getCause());
    } catch (IOException e) {
      throw Outputs.failed(target, e);
    }
  }

  @Override
  public void close() throws IOException {
    file.close();
  }
}
