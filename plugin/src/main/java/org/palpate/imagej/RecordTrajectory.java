package org.palpate.imagej;

import ij.IJ;
import ij.io.SaveDialog;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.palpate.host.TrajectoryRecording;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackSessionRunner;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * "Record Trajectory...": touches the active stack and records what the device sends into a file
 * that can be replayed. The file is complete when the session has ended.
 */
public final class RecordTrajectory extends PalpateCommand {
  /** Creates the command; ImageJ calls this. */
  public RecordTrajectory() {
    super("Record Trajectory");
  }

  @Override
  void execute() throws TouchRefusedException {
    CurrentSession.requireNoneRunning();
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    if (volume.hasMoreChannelsOrTimes() && !TouchVolume.confirmShownChannel(volume)) {
      return;
    }
    TouchOptions options = TouchOptions.ask("Record Trajectory", volume, true);
    if (options == null) {
      return;
    }
    SaveDialog where = new SaveDialog("Record Trajectory", "trajectory", ".csv");
    if (where.getFileName() != null) {
      Path target = Path.of(where.getDirectory(), where.getFileName());
      StackSessionRunner.begin(volume, options, Optional.of(record(target)));
    }
  }

  private static TrajectoryRecording record(Path target) throws TouchRefusedException {
    try {
      return new TrajectoryRecording(target);
    } catch (IOException e) {
      throw StackSessionRunner.notWritten(target, e);
    }
  }
}
