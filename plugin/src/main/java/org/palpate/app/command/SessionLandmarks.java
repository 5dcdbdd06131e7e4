package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.palpate.geometry.Vec3;
import org.palpate.io.table.Landmark;
import org.palpate.io.table.LandmarkFiles;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.WindowInput;

/** The landmarks that keys of the window set, name, undo and save. Any thread. */
final class SessionLandmarks {
  private final Supplier<Vec3> pointWorldMm;
  private final WorldAxes axes;
  private final Consumer<List<NamedPoint>> view;
  private final Consumer<String> out;
  private final List<Landmark> landmarks = new ArrayList<>();
  private int set;

  /**
   * Creates an empty list.
   *
   * @param pointWorldMm gives the interaction point; NaN before the first frame
   * @param axes orientation of the world's axes
   * @param view receives all landmarks after each change, world mm
   * @param out receives a line about each file
   */
  SessionLandmarks(
      Supplier<Vec3> pointWorldMm,
      WorldAxes axes,
      Consumer<List<NamedPoint>> view,
      Consumer<String> out) {
    this.pointWorldMm = pointWorldMm;
    this.axes = axes;
    this.view = view;
    this.out = out;
  }

  /** Adds the keys. */
  void addKeys(WindowInput input) {
    input.onKey('m', "set a landmark at the point and name it", () -> set(input));
    input.onKey('z', "undo the last landmark", this::undo);
    input.onKey('k', "save the landmarks", this::save);
  }

  private synchronized void set(WindowInput input) {
    Vec3 at = pointWorldMm.get();
    if (at.isFinite()) {
      set++;
      String name = "L" + set;
      landmarks.add(new Landmark(name, at));
      show();
      input.ask("Name of the landmark:", name, typed -> rename(at, typed));
    }
  }

  private synchronized void rename(Vec3 at, String name) {
    landmarks.replaceAll(mark -> mark.worldMm() == at ? new Landmark(name, at) : mark);
    show();
  }

  private synchronized void undo() {
    if (!landmarks.isEmpty()) {
      landmarks.remove(landmarks.size() - 1);
      show();
    }
  }

  private void show() {
    view.accept(
        landmarks.stream().map(mark -> new NamedPoint(mark.name(), mark.worldMm())).toList());
  }

  /** Writes a table in the world of the file, and a file for 3D Slicer if its axes are known. */
  private synchronized void save() {
    String stem = "palpate-landmarks-" + System.currentTimeMillis();
    try {
      LandmarkFiles.writeCsv(Path.of(stem + ".csv"), landmarks);
      if (axes != WorldAxes.UNKNOWN) {
        LandmarkFiles.writeFcsv(
            Path.of(stem + ".fcsv"), landmarks.stream().map(this::inLps).toList());
      }
      out.accept("landmarks: " + stem + ".csv (" + landmarks.size() + ")");
    } catch (IOException e) {
      out.accept("the landmarks could not be written: " + stem + ": " + e.getMessage());
    }
  }

  /** Returns a landmark in LPS, which is the frame of the scene. */
  private Landmark inLps(Landmark mark) {
    return new Landmark(mark.name(), axes.toSceneOrBack(mark.worldMm(), new Vec3()));
  }
}
