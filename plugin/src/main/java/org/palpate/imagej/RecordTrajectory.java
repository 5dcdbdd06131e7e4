package org.palpate.imagej;

import ij.IJ;
import ij.io.SaveDialog;
import java.nio.file.Path;
import java.util.Optional;

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
  void execute() throws StackRefused {
    Sessions.refuseSecond();
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    if (volume.isOneOfSeveral() && !TouchVolume.asksFor(volume)) {
      return;
    }
    TouchOptions options = TouchOptions.ask("Record Trajectory", volume, true);
    if (options == null) {
      return;
    }
    SaveDialog where = new SaveDialog("Record Trajectory", "trajectory", ".csv");
    if (where.getFileName() != null) {
      Path target = Path.of(where.getDirectory(), where.getFileName());
      TouchRun.begin(volume, options, Optional.of(new StackRecording(target)));
    }
  }
}
