package org.palpate.imagej;

import ij.IJ;
import ij.gui.GenericDialog;
import ij.measure.ResultsTable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.device.Trajectory;
import org.palpate.host.ContactScene;
import org.palpate.host.ReplayRun;
import org.palpate.host.TrajectoryFile;
import org.palpate.imagej.dialog.FilePaths;
import org.palpate.imagej.dialog.HelpText;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.stack.PixelSnapshot;
import org.palpate.imagej.stack.SegmentRange;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.StackGreyValues;
import org.palpate.imagej.stack.StackSegments;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * "Replay Trajectory...": runs the frames of a recorded trajectory over the active stack, and shows
 * time, interaction point, force and contact of each frame in the table "Palpate Frames".
 */
public final class ReplayTrajectory extends PalpateCommand {
  static final String TABLE = "Palpate Frames";

  /** Creates the command; ImageJ calls this. */
  public ReplayTrajectory() {
    super("Replay Trajectory");
  }

  @Override
  void execute() throws TouchRefusedException {
    StackVolume volume = StackVolume.shownIn(IJ.getImage());
    GenericDialog dialog = new GenericDialog("Replay Trajectory");
    dialog.addFileField("Trajectory", "", 30);
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    Path file = FilePaths.of("recorded trajectory", dialog.getNextString());
    TouchOptions options = TouchOptions.ask("Replay Trajectory", volume, false);
    if (options != null) {
      replay(volume, options, read(file));
    }
  }

  private static Trajectory read(Path file) throws TouchRefusedException {
    try {
      return TrajectoryFile.read(file, true);
    } catch (IOException e) {
      throw new TouchRefusedException("The trajectory cannot be read: " + e.getMessage());
    }
  }

  private static void replay(StackVolume volume, TouchOptions options, Trajectory trajectory)
      throws TouchRefusedException {
    StackGeometry geometry = StackGeometry.of(volume.image());
    List<SegmentRange> ranges = options.ranges(volume);
    PixelSnapshot pixels = new PixelSnapshot(volume);
    List<Segment> segments =
        StackSegments.of(
            volume, pixels::slice, ranges, k -> IJ.showProgress(k + 1, volume.slices()));
    options.materials().checkNamed(segments);
    ContactScene scene =
        new ContactScene(
            new SegmentedVolume(geometry.grid(), segments),
            options.contactSettings(),
            StackGreyValues.surface(pixels, volume.slices(), geometry.grid(), ranges));
    volume.logWarning(scene.settings().solver());
    ResultsTable table = new ResultsTable();
    ReplayRun rigid = ReplayRun.inWorld(scene, trajectory);
    Optional<ReplayRun> elastic =
        options.materials().bodies(scene.volume()).map(rigid::withElastic);
    try {
      elastic
          .orElse(rigid)
          .run(
              (frame, device, point, force, state, freed) -> {
                table.incrementCounter();
                table.addValue("t (ms)", trajectory.timeMs(frame));
                table.addValue("px (mm)", point.x);
                table.addValue("py (mm)", point.y);
                table.addValue("pz (mm)", point.z);
                table.addValue("fx (N)", force.x);
                table.addValue("fy (N)", force.y);
                table.addValue("fz (N)", force.z);
                table.addValue("contact", state.contact ? 1 : 0);
              });
    } catch (IOException e) {
      throw new TouchRefusedException("The replay failed: " + e.getMessage());
    }
    table.show(TABLE);
  }
}
