package org.palpate.app.options;

import java.io.PrintWriter;
import java.util.List;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import org.palpate.io.scene.Ghosts;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import picocli.CommandLine.Option;

/** The option that shows ghosts: segments of other files, to aim at. */
public final class GhostOptions {
  /** The name of the option. */
  public static final String NAME = "--ghost";

  @Option(
      names = NAME,
      paramLabel = "FILE[:SPEC]",
      description = {
        "Draws a segment of another volume file, or a closed mesh, faintly, to aim at; nothing"
            + " touches it. May be repeated. SPEC is >=1500, 300..900, label:7, name:Mandible or"
            + " nonzero. Default: nonzero."
      })
  private List<String> ghosts = List.of();

  /**
   * Refuses ghosts that have no effect.
   *
   * @param isHeadless whether the user wants no window
   * @param isPlaced whether bodies are read against ghosts
   * @throws PalpateException exit code 2, if nothing shows and nothing reads them
   */
  public void check(boolean isHeadless, boolean isPlaced) {
    if (!ghosts.isEmpty() && isHeadless && !isPlaced) {
      throw PalpateException.wrongUse(
          "no window shows a ghost, and no body is read against it",
          "--ghost with --headless",
          "leave one of them out, or choose --scene FILE.json or --phantom fracture");
    }
  }

  /**
   * Reads the ghosts.
   *
   * @param world the directions of the scene's world axes
   * @param err receives a line for each note
   * @return empty if none was asked for
   * @throws VolumeFormatException if one cannot be read or has no voxel
   */
  public Optional<Ghosts> read(CoordinateSystem world, PrintWriter err)
      throws VolumeFormatException {
    if (ghosts.isEmpty()) {
      return Optional.empty();
    }
    Ghosts read = Ghosts.read(ghosts, world);
    read.notes().forEach(err::println);
    err.flush();
    return Optional.of(read);
  }
}
