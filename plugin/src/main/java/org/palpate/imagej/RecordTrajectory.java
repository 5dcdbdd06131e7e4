package org.palpate.imagej;

import ij.IJ;
import ij.io.SaveDialog;
import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Optional;
import org.palpate.interaction.FrameRecorder;
import org.palpate.interaction.RecordingThread;
import org.palpate.interaction.TrajectoryText;
import org.palpate.io.CsvNumbers;
import org.palpate.io.NewFile;

/**
 * "Record Trajectory...": touches the stack in front and writes what the device sends into a file
 * that replays.
 */
public final class RecordTrajectory extends PalpateCommand {
  /** Made by ImageJ. */
  public RecordTrajectory() {
    super("Record Trajectory");
  }

  @Override
  void execute() throws StackRefused {
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    TouchOptions options = TouchOptions.ask(volume);
    if (options == null) {
      return;
    }
    SaveDialog where = new SaveDialog("Record Trajectory", "trajectory", ".csv");
    if (where.getFileName() != null) {
      record(volume, options, Path.of(where.getDirectory(), where.getFileName()));
    }
  }

  private static void record(StackVolume volume, TouchOptions options, Path target)
      throws StackRefused {
    FrameRecorder recorder = new FrameRecorder();
    try (NewFile file = new NewFile(target)) {
      Writer writer = new OutputStreamWriter(file.stream(), StandardCharsets.UTF_8);
      RecordingThread thread =
          RecordingThread.start(recorder, new TrajectoryText(writer, CsvNumbers::text));
      try {
        TouchVolume.touch(volume, options, Optional.of(recorder));
      } finally {
        thread.close();
      }
      writer.flush();
      file.commit();
    } catch (IOException | UncheckedIOException e) {
      throw new StackRefused(
          "The trajectory cannot be written to " + target + ": " + e.getMessage());
    }
    IJ.showStatus("Palpate: " + recorder.recorded() + " samples recorded in " + target);
  }
}
