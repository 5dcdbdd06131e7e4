package org.palpate.imagej;

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

/** What the device sends, on its way into a file that replays. One thread at a time. */
final class StackRecording implements AutoCloseable {
  private final Path target;
  private final NewFile file;
  private final Writer writer;
  private final FrameRecorder recorder = new FrameRecorder();
  private final RecordingThread thread;

  /**
   * Starts to record.
   *
   * @throws StackRefused where there can be no such file
   */
  StackRecording(Path target) throws StackRefused {
    this.target = target;
    try {
      file = new NewFile(target);
      writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw refused(e);
    }
    thread = RecordingThread.start(recorder, new TrajectoryText(writer, CsvNumbers::text));
  }

  private StackRefused refused(Exception cause) {
    return new StackRefused(
        "The trajectory cannot be written to " + target + ": " + cause.getMessage());
  }

  FrameRecorder recorder() {
    return recorder;
  }

  /**
   * Ends the file and moves it over its target, after the session's last frame.
   *
   * @throws StackRefused where it could not be written
   */
  void finish() throws StackRefused {
    try {
      thread.close();
      writer.flush();
      file.commit();
    } catch (IOException | UncheckedIOException e) {
      throw refused(e);
    }
  }

  /** Lets go; what was not finished leaves no file. Any number of times. */
  @Override
  public void close() {
    try {
      thread.close();
      file.close();
    } catch (IOException | UncheckedIOException e) {
      // the file was given up; finish has told why where it was wanted
    }
  }
}
