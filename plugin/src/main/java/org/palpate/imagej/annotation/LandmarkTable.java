package org.palpate.imagej.annotation;

import ij.ImagePlus;
import ij.gui.Overlay;
import ij.gui.PointRoi;
import ij.gui.TextRoi;
import ij.measure.ResultsTable;
import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.palpate.geometry.Vec3;
import org.palpate.imagej.stack.StackGeometry;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.table.Landmark;
import org.palpate.io.table.LandmarkFiles;
import org.palpate.scene.NamedPoint;

/**
 * The landmarks of a session: rows of an ImageJ table in calibrated units, marks in the stack's
 * overlay, and files. Any thread.
 */
public final class LandmarkTable {
  static final String TITLE = "Palpate Landmarks";

  private static final Color MARK = new Color(0xCC79A7);
  private static final int TEXT_OFFSET_PIXELS = 2;

  private final ImagePlus image;
  private final StackGeometry geometry;
  private final Consumer<List<NamedPoint>> view;
  private final List<Landmark> landmarks = new ArrayList<>();

  /**
   * Creates an empty table.
   *
   * @param view receives all landmarks, in world mm, after each addition
   */
  public LandmarkTable(ImagePlus image, StackGeometry geometry, Consumer<List<NamedPoint>> view) {
    this.image = image;
    this.geometry = geometry;
    this.view = view;
  }

  /** Returns a name for the next landmark: L1, L2 and so on. */
  public synchronized String nextName() {
    return "L" + (landmarks.size() + 1);
  }

  /**
   * Adds a landmark.
   *
   * @param grid its position, grid coordinates
   */
  public synchronized void add(String name, Vec3 grid) {
    landmarks.add(new Landmark(name, geometry.grid().gridToWorld(grid, new Vec3())));
    addRow(name, geometry.gridToCalibrated(grid, new Vec3()));
    mark(name, grid);
    view.accept(
        landmarks.stream().map(mark -> new NamedPoint(mark.name(), mark.worldMm())).toList());
  }

  private void addRow(String name, Vec3 calibrated) {
    ResultsTable open = ResultsTable.getResultsTable(TITLE);
    ResultsTable table = open == null ? new ResultsTable() : open;
    table.incrementCounter();
    table.addValue("Name", name);
    table.addValue("X", calibrated.x);
    table.addValue("Y", calibrated.y);
    table.addValue("Z", calibrated.z);
    table.addValue("Unit", geometry.unit());
    table.show(TITLE);
  }

  private void mark(String name, Vec3 grid) {
    int slice = Math.max(1, Math.min(image.getNSlices(), (int) Math.floor(grid.z) + 1));
    PointRoi point = new PointRoi(grid.x, grid.y);
    point.setStrokeColor(MARK);
    TextRoi text = new TextRoi(grid.x + TEXT_OFFSET_PIXELS, grid.y + TEXT_OFFSET_PIXELS, name);
    text.setStrokeColor(MARK);
    if (image.isHyperStack()) {
      point.setPosition(0, slice, 0);
      text.setPosition(0, slice, 0);
    } else {
      point.setPosition(slice);
      text.setPosition(slice);
    }
    Overlay overlay = image.getOverlay() == null ? new Overlay() : image.getOverlay();
    overlay.add(point);
    overlay.add(text);
    image.setOverlay(overlay);
  }

  /**
   * Writes {@code landmarks.csv}, and {@code landmarks.fcsv} for 3D Slicer, in world mm.
   *
   * @throws TouchRefusedException if they cannot be written
   */
  public synchronized void save(Path folder) throws TouchRefusedException {
    try {
      LandmarkFiles.writeCsv(folder.resolve("landmarks.csv"), landmarks);
      LandmarkFiles.writeFcsv(folder.resolve("landmarks.fcsv"), landmarks);
    } catch (IOException e) {
      throw new TouchRefusedException(
          "The landmarks cannot be saved in " + folder + ": " + e.getMessage());
    }
  }
}
