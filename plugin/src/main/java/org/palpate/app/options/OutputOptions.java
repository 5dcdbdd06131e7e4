package org.palpate.app.options;

import java.nio.file.Path;
import java.util.Optional;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The options that every command has. */
public final class OutputOptions {
  @Option(
      names = "--report",
      paramLabel = "FILE.json",
      description = "Writes the measurements as JSON.")
  private Path report;

  @Option(names = "--debug", description = "Prints the stack trace of an error.")
  @SuppressWarnings("UnusedVariable") // PalpateCommandLine looks for the argument itself
  private boolean debug;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Prints this help and ends.")
  @SuppressWarnings("UnusedVariable") // picocli reads it
  private boolean help;

  /** Returns the file of the report, if one was asked for. */
  public Optional<Path> report() {
    return Optional.ofNullable(report);
  }

  /**
   * Returns the folder that {@code --out} names, for commands that write many files. It need not
   * exist yet.
   *
   * @throws PalpateException exit code 2, if a file has that name
   */
  public Path checked(Path folder) {
    return OutputPaths.checkedFolder("--out", folder);
  }
}
