package org.palpate.imagej.session;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;
import org.palpate.recording.RecordingThread;
import org.palpate.recording.SampleRecorder;
import org.palpate.recording.TrajectoryWriter;

/** What the device sends, on its way into a file that replays. One thread at a time. */
public final class StackRecording implements AutoCloseable {
  private final Path target;
  private final AtomicFile file;
  private final Writer writer;
  private final SampleRecorder recorder = new SampleRecorder();
  private final RecordingThread thread;

  /**
   * Starts to record.
   *
   * @throws TouchRefusedException where there can be no such file
   */
  public StackRecording(Path target) throws TouchRefusedException {
    this.target = target;
    try {
      file = new AtomicFile(target);
      writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw refused(e);
    }
    thread = RecordingThread.start(recorder, new TrajectoryWriter(writer, NumberText::text));
  }

  private TouchRefusedException refused(Exception cause) {
    return new TouchRefusedException(
        "The trajectory cannot be written to " + target + ": " + cause.getMessage());
  }

  SampleRecorder recorder() {
    return recorder;
  }

  /**
   * Ends the file and moves it over its target, after the session's last frame.
   *
   * @throws TouchRefusedException where it could not be written
   */
  void finish() throws TouchRefusedException {
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
