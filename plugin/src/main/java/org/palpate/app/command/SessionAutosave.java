package org.palpate.app.command;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.output.WriteFailures;
import org.palpate.app.process.PalpateException;
import org.palpate.body.BodyGroups;
import org.palpate.frame.ToolFrame;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.SceneAutosave;
import org.palpate.io.scene.AutosaveFiles;
import org.palpate.io.scene.OpenedScene;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SavedScene;

/**
 * The autosave of a session whose bodies can move: where it is, what the user reads about it, and
 * whether it stays at the end. One thread.
 */
final class SessionAutosave {
  private final PlacedVolume start;
  private final Optional<BodyGroups> groups;
  private final boolean cuts;
  private final boolean writesResult;
  private final Optional<SavedScene> target;
  private final PrintWriter out;
  private final PrintWriter err;

  /** The frame of the session, once there is one. */
  private ToolFrame frame;

  /**
   * Creates an autosave.
   *
   * @param groups the locks and groups with which the session begins
   * @param target receives the bodies; empty if the session is not saved
   */
  SessionAutosave(
      PlacedVolume start,
      Optional<BodyGroups> groups,
      boolean cuts,
      boolean writesResult,
      Optional<SavedScene> target,
      PrintWriter out,
      PrintWriter err) {
    this.start = start;
    this.groups = groups;
    this.cuts = cuts;
    this.writesResult = writesResult;
    this.target = target;
    this.out = out;
    this.err = err;
  }

  /**
   * Finds a place for the autosave of a session, and prints where it is and what earlier sessions
   * left.
   *
   * @param end the scene file that the session will write
   * @param cuts whether the session changes voxels
   * @param writesResult whether the session writes where the bodies are at its end
   * @return empty if no body can move
   * @throws IOException if the locks and groups beside the scene are not understood
   */
  static Optional<SessionAutosave> of(
      VolumeSource source,
      Optional<Path> end,
      boolean cuts,
      boolean writesResult,
      PrintWriter out,
      PrintWriter err)
      throws IOException {
    Optional<PlacedVolume> bodies = source.placed().filter(PlacedVolume::hasMovableBodies);
    if (bodies.isEmpty()) {
      return Optional.empty();
    }
    Optional<BodyGroups> groups = bodies.get().groups();
    List<AutosaveFiles> places = places(source, end);
    noteWhatIsLeft(places, source.origin(), out);
    Optional<SavedScene> target = Optional.empty();
    if (cuts && !bodies.get().rest().hasOneGrid()) {
      out.println(
          "The session is not saved while it runs, because its bodies are cut and have several"
              + " grids.");
    } else {
      target = claim(places, source.name(), err);
    }
    target.ifPresent(
        scene -> out.println("While a body moves, the scene is saved as " + scene.file() + "."));
    return Optional.of(
        new SessionAutosave(bodies.get(), groups, cuts, writesResult, target, out, err));
  }

  /** Returns where the autosave may be, the preferred place first. */
  private static List<AutosaveFiles> places(VolumeSource source, Optional<Path> end) {
    List<AutosaveFiles> places = new ArrayList<>();
    end.map(AutosaveFiles::beside).ifPresent(places::add);
    Optional<Path> scene = source.origin().map(OpenedScene::file);
    scene.map(AutosaveFiles::beside).ifPresent(places::add);
    String word = source.name().replaceFirst("^phantom ", "").replace(':', '-');
    places.add(
        scene.map(AutosaveFiles::awayFrom).orElseGet(() -> AutosaveFiles.inWorkingFolder(word)));
    return places;
  }

  /** Names what sessions of the same input left, unless it is the scene that is resumed. */
  private static void noteWhatIsLeft(
      List<AutosaveFiles> places, Optional<OpenedScene> resumed, PrintWriter out) {
    List<Path> named = new ArrayList<>();
    resumed.ifPresent(scene -> named.add(absolute(scene.file())));
    for (AutosaveFiles place : places) {
      Optional<Path> last = place.last().filter(left -> !named.contains(absolute(left)));
      last.ifPresent(
          left -> {
            named.add(absolute(left));
            out.println(
                "An earlier session did not save its result: --scene "
                    + left
                    + " resumes it. Delete the files of that name once they are not needed.");
          });
    }
  }

  private static Path absolute(Path file) {
    return file.toAbsolutePath().normalize();
  }

  private static Optional<SavedScene> claim(
      List<AutosaveFiles> places, String input, PrintWriter err) {
    try {
      return Optional.of(AutosaveFiles.claimFirst(places));
    } catch (IOException e) {
      err.println(
          "palpate: "
              + PalpateException.failed(
                      "the session is not saved while it runs (" + e.getMessage() + ")",
                      input,
                      "make the folder of the input or the working folder writable",
                      e)
                  .getMessage());
      return Optional.empty();
    }
  }

  /**
   * Gives the bodies of a session the locks and groups that were saved with its scene.
   *
   * @return what saves the session while it runs; empty if it is not saved
   */
  Optional<SceneAutosave> begin(TouchSession session) {
    frame = session.toolFrame().orElseThrow();
    groups.ifPresent(frame::requestGroups);
    return target.map(
        scene ->
            new SceneAutosave(
                start,
                cuts,
                frame,
                scene,
                cause -> err.println(WriteFailures.line(scene.file(), cause))));
  }

  /** Returns the locks and groups of the session that began, as they are now. */
  BodyGroups groups() {
    return frame.groups();
  }

  /**
   * Deletes the autosave, or leaves it if it holds what nothing else does. Call it after the thread
   * of the session's autosave has ended.
   *
   * @param left the bodies as the session left them
   * @param inOrder whether the last frame was whole
   * @param byHand whether a person may have moved bodies
   * @param failures the failures of the outputs, to which those of the autosave are added
   */
  void end(PlacedVolume left, boolean inOrder, boolean byHand, WriteFailures failures) {
    boolean isSaved = writesResult && failures.exitCode() == 0;
    target.ifPresent(
        scene ->
            failures.attempt(scene.file(), () -> end(scene, left, inOrder, isSaved || !byHand)));
  }

  private void end(SavedScene scene, PlacedVolume left, boolean inOrder, boolean isDone)
      throws IOException {
    try (scene) {
      if (inOrder && isDone) {
        scene.delete();
      } else if (scene.isWritten()) {
        if (inOrder) {
          scene.write(left, cuts, frame.groups());
        }
        out.println("The result was not saved: --scene " + scene.file() + " goes on from it.");
      }
    }
  }
}
