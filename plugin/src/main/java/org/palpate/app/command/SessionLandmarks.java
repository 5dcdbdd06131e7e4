package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import org.palpate.app.process.OutputPaths;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.placing.BodyAnchor;
import org.palpate.io.file.CountText;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.Landmark;
import org.palpate.io.table.LandmarkFiles;
import org.palpate.scene.NamedPoint;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.WindowInput;

/** The landmarks that keys of the window set, name, undo and save. Any thread. */
final class SessionLandmarks {
  private final Supplier<Vec3> pointWorldMm;
  private final IntSupplier touchedBody;
  private final Supplier<List<RigidTransform>> bodyPoses;
  private final WorldAxes axes;
  private final Consumer<List<NamedPoint>> view;
  private final Consumer<String> out;
  private final List<Mark> landmarks = new ArrayList<>();
  private List<RigidTransform> followed = List.of();
  private int set;

  /** A landmark that moves with the body on which it was set. */
  private record Mark(String name, BodyAnchor anchor) {}

  /**
   * Creates an empty list.
   *
   * @param pointWorldMm gives the interaction point; NaN before the first frame
   * @param touchedBody gives the movable body at that point; negative if there is none
   * @param bodyPoses gives the present poses of the bodies
   * @param axes orientation of the world's axes
   * @param view receives all landmarks after each change, world mm
   * @param out receives a line about each file
   */
  SessionLandmarks(
      Supplier<Vec3> pointWorldMm,
      IntSupplier touchedBody,
      Supplier<List<RigidTransform>> bodyPoses,
      WorldAxes axes,
      Consumer<List<NamedPoint>> view,
      Consumer<String> out) {
    this.pointWorldMm = pointWorldMm;
    this.touchedBody = touchedBody;
    this.bodyPoses = bodyPoses;
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
      BodyAnchor anchor = BodyAnchor.at(at, touchedBody.getAsInt(), bodyPoses.get());
      landmarks.add(new Mark(name, anchor));
      show();
      input.ask("Name of the landmark:", name, typed -> rename(anchor, typed));
    }
  }

  private synchronized void rename(BodyAnchor anchor, String name) {
    landmarks.replaceAll(mark -> mark.anchor.equals(anchor) ? new Mark(name, anchor) : mark);
    show();
  }

  /** Shows landmarks where their bodies are now, and returns the distance of the last two. */
  synchronized List<String> follow() {
    List<Landmark> now = present();
    if (!bodyPoses.get().equals(followed)) {
      followed = bodyPoses.get();
      show();
    }
    if (now.size() < 2) {
      return List.of();
    }
    Landmark one = now.get(now.size() - 2);
    Landmark other = now.get(now.size() - 1);
    double mm = one.worldMm().sub(other.worldMm(), new Vec3()).length();
    return List.of(one.name() + " to " + other.name() + ": " + NumberText.thousandths(mm) + " mm");
  }

  private List<Landmark> present() {
    List<RigidTransform> poses = bodyPoses.get();
    return landmarks.stream()
        .map(mark -> new Landmark(mark.name, mark.anchor.present(poses)))
        .toList();
  }

  private synchronized void undo() {
    if (!landmarks.isEmpty()) {
      landmarks.remove(landmarks.size() - 1);
      show();
    }
  }

  private void show() {
    view.accept(
        present().stream().map(mark -> new NamedPoint(mark.name(), mark.worldMm())).toList());
  }

  /** Writes a table in the world of the file, and a file for 3D Slicer if its axes are known. */
  private synchronized void save() {
    String stem = "palpate-landmarks-" + System.currentTimeMillis();
    try {
      List<Landmark> now = present();
      LandmarkFiles.writeCsv(Path.of(stem + ".csv"), now);
      if (axes != WorldAxes.UNKNOWN) {
        LandmarkFiles.writeFcsv(Path.of(stem + ".fcsv"), now.stream().map(this::inLps).toList());
      }
      out.accept(OutputPaths.written(Path.of(stem + ".csv"), CountText.of(now.size(), "landmark")));
    } catch (IOException e) {
      out.accept("the landmarks could not be written: " + stem + ": " + e.getMessage());
    }
  }

  /** Returns a landmark in LPS, which is the frame of the scene. */
  private Landmark inLps(Landmark mark) {
    return new Landmark(mark.name(), axes.toSceneOrBack(mark.worldMm(), new Vec3()));
  }
}
