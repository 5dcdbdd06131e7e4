package org.palpate.imagej.session;

import ij.IJ;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.palpate.body.BodyGroups;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Vec3;
import org.palpate.host.placing.SceneAutosave;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.io.scene.AutosaveFiles;
import org.palpate.io.scene.BodyReader;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SavedScene;
import org.palpate.io.scene.SceneBody;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneReader;
import org.palpate.io.table.GroupsCsv;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * The autosave of fragments that are placed, and what an earlier session of the same stack left. It
 * lies beside the file of the stack, or else in the working folder or the user's folder. One thread
 * at a time.
 */
final class PlacingAutosave implements AutoCloseable {
  private final Optional<SavedScene> target;
  private final Optional<SceneAutosave> saving;

  /**
   * The placements, locks and groups with which fragments begin.
   *
   * @param placements the placement of each fragment, in their order
   * @param groups their locks and groups; empty for none
   */
  record Start(List<Placement> placements, Optional<BodyGroups> groups) {}

  /**
   * Finds a place for the autosave, and logs where it is and what an earlier session left.
   *
   * @param bodies the fragments where they begin
   * @param frame gives their poses while the session runs
   */
  PlacingAutosave(StackVolume stack, PlacedVolume bodies, ToolFrame frame) {
    left(stack)
        .ifPresent(
            file ->
                log(
                    "An earlier session did not end in order, and left "
                        + file
                        + ". The field Resume goes on from it. Delete the files of that name once"
                        + " they are not needed."));
    target = claim(stack);
    target.ifPresent(
        scene -> log("While a fragment moves, the scene is saved as " + scene.file() + "."));
    saving =
        target.map(
            scene ->
                new SceneAutosave(
                    bodies,
                    false,
                    frame,
                    scene,
                    cause -> log(scene.file() + " cannot be written: " + cause.getMessage())));
  }

  private static void log(String line) {
    IJ.log("Palpate: " + line);
  }

  /** Returns where the autosave of a stack may be, the preferred place first. */
  private static List<AutosaveFiles> places(StackVolume stack) {
    String title = stack.image().getTitle().strip().replaceAll("[^\\p{L}\\p{N}._-]+", "_");
    String word = title.isEmpty() ? "stack" : title;
    Path working = Path.of(word).toAbsolutePath();
    Path home = Path.of(System.getProperty("user.home"), word);
    return Stream.concat(stack.file().stream(), Stream.of(working, home))
        .map(AutosaveFiles::beside)
        .toList();
  }

  private static Optional<SavedScene> claim(StackVolume stack) {
    try {
      return Optional.of(AutosaveFiles.claimFirst(places(stack)));
    } catch (IOException e) {
      log("The session is not saved while it runs: " + e.getMessage());
      return Optional.empty();
    }
  }

  /** Returns the last scene that an earlier session of a stack left, if any. */
  private static Optional<Path> left(StackVolume stack) {
    return places(stack).stream().flatMap(place -> place.last().stream()).findFirst();
  }

  /**
   * Returns where an earlier session of a stack left the fragments.
   *
   * @param fragments the fragments as they are in the stack
   * @param atRest their placements in the stack, which give the mobility
   * @throws TouchRefusedException if none was left, or it has other fragments or is damaged
   */
  static Start resume(StackVolume stack, SegmentedVolume fragments, List<Placement> atRest)
      throws TouchRefusedException {
    Optional<Path> file = left(stack);
    if (file.isEmpty()) {
      throw new TouchRefusedException("No earlier session of this stack is left to resume.");
    }
    try {
      SceneFile scene = SceneReader.read(file.get());
      List<String> names = fragments.segments().stream().map(Segment::name).toList();
      if (!scene.bodies().stream().map(SceneBody::name).toList().equals(names)
          || !areSame(BodyReader.read(scene, file.get()).rest(), fragments)) {
        throw new TouchRefusedException(
            file.get() + " has other fragments than the stack: leave Resume out.");
      }
      List<Placement> placements = new ArrayList<>();
      for (SceneBody body : scene.bodies()) {
        placements.add(new Placement(atRest.get(placements.size()).mobility(), body.pose()));
      }
      return new Start(
          placements,
          GroupsCsv.read(
              GroupsCsv.beside(file.get()),
              names,
              body -> placements.get(body).mobility() == Mobility.MOVABLE));
    } catch (IOException e) {
      throw new TouchRefusedException("The session cannot be resumed: " + e.getMessage());
    }
  }

  /** Whether fragments have the same voxels, which may differ in a stack of the same title. */
  private static boolean areSame(SegmentedVolume one, SegmentedVolume other) {
    boolean same = one.grid().spacingMm().sub(other.grid().spacingMm(), new Vec3()).length() < 1e-6;
    for (int n = 0; n < one.segments().size() && same; n++) {
      same = haveSameVoxels(one.segments().get(n).bits(), other.segments().get(n).bits());
    }
    return same;
  }

  private static boolean haveSameVoxels(BitCube one, BitCube other) {
    boolean same =
        one.sizeX() == other.sizeX()
            && one.sizeY() == other.sizeY()
            && one.sizeZ() == other.sizeZ();
    for (int z = 0; z < one.bricksZ() && same; z++) {
      for (int y = 0; y < one.bricksY() && same; y++) {
        for (int x = 0; x < one.bricksX() && same; x++) {
          same = one.brick(x, y, z) == other.brick(x, y, z);
        }
      }
    }
    return same;
  }

  /** Starts to save. */
  void start() {
    saving.ifPresent(SceneAutosave::start);
  }

  /** Deletes what was saved, because the result is shown. */
  void discard() {
    saving.ifPresent(SceneAutosave::close);
    target.ifPresent(
        scene -> {
          try {
            scene.delete();
          } catch (IOException e) {
            log(scene.file() + " cannot be deleted: " + e.getMessage());
          }
        });
  }

  /** Ends the thread that saves, and gives the name of the file back. */
  @Override
  public void close() {
    saving.ifPresent(SceneAutosave::close);
    target.ifPresent(
        scene -> {
          try {
            scene.close();
          } catch (IOException e) {
            log(scene.file() + " stays locked: " + e.getMessage());
          }
        });
  }
}
