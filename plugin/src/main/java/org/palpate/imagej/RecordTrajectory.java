package org.palpate.imagej;

import ij.IJ;
import ij.io.SaveDialog;
import java.nio.file.Path;
import java.util.Optional;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackRecording;
import org.palpate.imagej.session.StackSessionRunner;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;

/**
 * "Record Trajectory...": touches the stack in front and writes what the device sends into a file
 * that replays; the file is there when the session has ended.
 */
public final class RecordTrajectory extends PalpateCommand {
  /** Made by ImageJ. */
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
      StackSessionRunner.begin(volume, options, Optional.of(new StackRecording(target)));
    }
  }
}
