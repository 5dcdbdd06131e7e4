package org.palpate.imagej;

import ij.IJ;
import ij.ImagePlus;
import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.TextRoi;
import ij.measure.ResultsTable;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.io.Landmark;
import org.palpate.io.LandmarkFiles;

/**
 * "Landmarks": puts a named point where the interaction point is, into the table "Palpate
 * Landmarks" in calibrated units and into the stack's overlay. A macro can give a name, and a
 * folder to save the table and a file for 3D Slicer in.
 */
public final class Landmarks extends PalpateCommand {
  static final String TABLE = "Palpate Landmarks";

  private static final Color MARK = new Color(0xE69F00);

  /** Made by ImageJ. */
  public Landmarks() {
    super("Landmarks");
  }

  @Override
  void execute() throws StackRefused {
    StackSession session = Sessions.current();
    Vec3 grid = session.tipGrid();
    if (!grid.isFinite()) {
      throw new StackRefused("The first frame has not run yet: touch the volume first.");
    }
    List<Landmark> landmarks = session.landmarks();
    ij.gui.GenericDialog dialog = new ij.gui.GenericDialog("Landmark");
    dialog.addStringField("Name", "L" + (landmarks.size() + 1), 16);
    dialog.addStringField("Save in folder (empty: do not save)", "", 30);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    String name = dialog.getNextString();
    String folder = dialog.getNextString().strip();
    Vec3 worldMm = session.geometry().grid().gridToWorld(grid, new Vec3());
    synchronized (landmarks) {
      landmarks.add(new Landmark(name, worldMm));
      addRow(session, name, grid);
      mark(session.volume().image(), name, grid);
      if (!folder.isEmpty()) {
        save(Path.of(folder), landmarks);
      }
    }
  }

  private static void addRow(StackSession session, String name, Vec3 grid) {
    Vec3 at = session.geometry().gridToCalibrated(grid, new Vec3());
    ResultsTable open = ResultsTable.getResultsTable(TABLE);
    ResultsTable table = open == null ? new ResultsTable() : open;
    table.incrementCounter();
    table.addValue("Name", name);
    table.addValue("X", at.x);
    table.addValue("Y", at.y);
    table.addValue("Z", at.z);
    table.addValue("Unit", session.geometry().unit());
    table.show(TABLE);
  }

  private static void mark(ImagePlus image, String name, Vec3 grid) {
    int slice = Math.max(1, Math.min(image.getNSlices(), (int) Math.floor(grid.z) + 1));
    PointRoi point = new PointRoi(grid.x, grid.y);
    point.setStrokeColor(MARK);
    point.setPosition(0, slice, 0);
    TextRoi text = new TextRoi(grid.x + 2, grid.y + 2, name);
    text.setStrokeColor(MARK);
    text.setPosition(0, slice, 0);
    Overlay overlay = image.getOverlay() == null ? new Overlay() : image.getOverlay();
    overlay.add(point);
    overlay.add(text);
    image.setOverlay(overlay);
  }

  private static void save(Path folder, List<Landmark> landmarks) throws StackRefused {
    try {
      LandmarkFiles.writeCsv(folder.resolve("landmarks.csv"), landmarks);
      LandmarkFiles.writeFcsv(folder.resolve("landmarks.fcsv"), landmarks);
      IJ.showStatus("Palpate: landmarks saved in " + folder);
    } catch (IOException e) {
      throw new StackRefused("The landmarks cannot be saved in " + folder + ": " + e.getMessage());
    }
  }
}
