package org.palpate.scijava;

import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.palpate.app.PalpateCommandLine;
import org.scijava.ItemIO;
import org.scijava.command.Command;
import org.scijava.plugin.Menu;
import org.scijava.plugin.Parameter;
import org.scijava.plugin.Plugin;

/**
 * "Replay Volume File...": replays a recorded trajectory over a volume file as the command {@code
 * palpate replay} does, with or without a screen, and writes the same bytes.
 *
 * <p>SciJava finds it by the index in {@code META-INF/json}, and writes and reads its fields.
 */
@Plugin(
    type = Command.class,
    headless = true,
    menu = {
      @Menu(label = "Plugins"),
      @Menu(label = "Palpate"),
      @Menu(label = "Replay Volume File...")
    })
@SuppressWarnings("UnusedVariable") // SciJava reads the outputs
public final class ReplayFile implements Command {
  @Parameter(label = "Volume", description = "NRRD, NIfTI, MetaImage, TIFF or DICOM")
  private File volume;

  @Parameter(
      label = "Segment",
      description = "NAME=SPEC, for example bone=>=1500 or jaw=label:7; empty for a label volume",
      required = false)
  private String segment = "";

  @Parameter(label = "Trajectory", description = "CSV with the columns t_ms,x,y,z")
  private File trajectory;

  @Parameter(
      label = "Coordinates",
      choices = {"world", "grid"},
      required = false)
  private String coordinates = "world";

  @Parameter(
      label = "Solver",
      choices = {"smooth", "guarded", "paper", "dot", "none"},
      required = false)
  private String solver = "smooth";

  @Parameter(label = "Frames", style = "save", description = "CSV with one row for each frame")
  private File frames;

  @Parameter(type = ItemIO.OUTPUT, label = "Done", description = "Whether the frames were written")
  private boolean done;

  @Parameter(
      type = ItemIO.OUTPUT,
      label = "Message",
      description = "The error; empty if there was none")
  private String message = "";

  /** Runs the command and stores its outcome in the outputs. */
  @Override
  public void run() {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int exitCode =
        new PalpateCommandLine(stream(out), stream(err)).run(arguments().toArray(String[]::new));
    done = exitCode == 0;
    message = err.toString(StandardCharsets.UTF_8).strip();
  }

  private static PrintStream stream(ByteArrayOutputStream bytes) {
    return new PrintStream(bytes, true, StandardCharsets.UTF_8);
  }

  private List<String> arguments() {
    List<String> arguments = new ArrayList<>(List.of("replay", "--volume", volume.getPath()));
    if (segment != null && !segment.isBlank()) {
      arguments.addAll(List.of("--segment", segment.strip()));
    }
    arguments.addAll(List.of("--trajectory", trajectory.getPath()));
    arguments.addAll(List.of("--coordinates", coordinates, "--solver", solver));
    arguments.addAll(List.of("--out", frames.getPath()));
    return arguments;
  }
}
