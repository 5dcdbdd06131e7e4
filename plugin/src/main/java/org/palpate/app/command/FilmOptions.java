package org.palpate.app.command;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.app.options.NumberRange;
import org.palpate.app.output.AnimatedGif;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.RigidTransform;
import org.palpate.io.table.BodyPose;
import org.palpate.io.table.PosesCsv;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SceneModel;
import org.palpate.scene.window.OffscreenRenderer;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;

/** The options of pictures of bodies that a table of poses moves. */
final class FilmOptions {
  /** The option that names the table. */
  static final String POSES = "--poses";

  /** The option that chooses how many pictures a film has. */
  static final String PICTURES = "--pictures";

  private static final NumberRange COUNT =
      new NumberRange(PICTURES, "the number of pictures", 2, 1000, "", "24");

  private static final double SECONDS = 0.25;
  private static final double LAST_SECONDS = 2;

  @Option(
      names = POSES,
      paramLabel = "POSES.csv",
      description = {
        "Poses of bodies, as replay reads and touch --record writes them. A .png shows the bodies"
            + " at the end of the table, a .gif from its start to its end."
      })
  private Path table;

  @Option(
      names = PICTURES,
      paramLabel = "N",
      defaultValue = "24",
      description =
          "Pictures of a .gif, evenly over the rows of the table. Default: ${DEFAULT-VALUE}.")
  private int pictures;

  /** Whether a file is a film. */
  static boolean isFilm(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".gif");
  }

  /** Returns the table of poses; empty if nothing moves the bodies. */
  Optional<Path> table() {
    return Optional.ofNullable(table);
  }

  /**
   * Checks the options.
   *
   * @param out the file to write
   * @param hasBodies whether there are bodies with poses
   * @param countIsGiven whether the number of pictures is asked for
   * @throws PalpateException exit code 2, if they do not go together
   */
  void check(Path out, boolean hasBodies, boolean countIsGiven) {
    COUNT.check(pictures);
    if (table != null && !hasBodies) {
      throw PalpateException.wrongUse(
          "the volume has no bodies that move",
          POSES,
          "leave it out, or choose --scene FILE.json or --phantom fracture");
    }
    if (isFilm(out) && table == null) {
      throw PalpateException.wrongUse(
          "nothing moves in the film", "--out " + out, "add --poses POSES.csv, or write a .png");
    }
    if (countIsGiven && !isFilm(out)) {
      throw PalpateException.wrongUse(
          "a single picture is written", PICTURES, "leave it out, or write a .gif");
    }
  }

  /**
   * Reads the table.
   *
   * @return its rows; none without a table
   * @throws IOException if it cannot be read or names an unknown body
   */
  List<BodyPose> read(SegmentedVolume bodies) throws IOException {
    return table == null
        ? List.of()
        : PosesCsv.read(table, bodies.segments().stream().map(Segment::name).toList());
  }

  /**
   * Draws a film from where the bodies stand. Time in which none moves is left out.
   *
   * @param rows the poses in the order of their frames
   * @param out receives the film
   */
  void draw(
      List<BodyPose> rows,
      SceneLoader bodies,
      SceneModel model,
      OffscreenRenderer renderer,
      OutputStream out)
      throws IOException {
    try (AnimatedGif film = new AnimatedGif(out)) {
      draw(rows, bodies, model, renderer, film);
    }
  }

  private void draw(
      List<BodyPose> rows,
      SceneLoader bodies,
      SceneModel model,
      OffscreenRenderer renderer,
      AnimatedGif film)
      throws IOException {
    int done = 0;
    for (int n = 0; n < pictures; n++) {
      int end = Math.toIntExact((long) rows.size() * n / (pictures - 1));
      move(rows.subList(done, end), bodies);
      done = end;
      boolean isLast = n == pictures - 1;
      film.add(renderer.draw(model.state()).toImage(), isLast ? LAST_SECONDS : SECONDS);
    }
  }

  /** Moves bodies of a scene to the poses that rows give them; of several, the last one counts. */
  static void move(List<BodyPose> rows, SceneLoader bodies) {
    for (BodyPose row : rows) {
      bodies.move(row.body(), row.restToPresent().transform(RigidTransform.identity()));
    }
  }
}
