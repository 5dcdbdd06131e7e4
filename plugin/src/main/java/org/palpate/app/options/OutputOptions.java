package org.palpate.app.options;

import java.nio.file.Path;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The options that every command has. */
public final class OutputOptions {
  @Option(
      names = "--report",
      paramLabel = "FILE.json",
      description = "Write what was measured, as JSON.")
  private Path report;

  @Option(names = "--debug", description = "Show the stack trace behind an error.")
  private boolean debug;

  @Option(
      names = {"-h", "--help"},
      usageHelp = true,
      description = "Show this help and end.")
  @SuppressWarnings("UnusedVariable") // picocli reads it
  private boolean help;

  /** Where the report goes, if one was asked for. */
  public Optional<Path> report() {
    return Optional.ofNullable(report);
  }

  /**
   * The folder that {@code --out} names, for commands that leave many files; it may be made later.
   *
   * @throws PalpateException exit code 2, where a file stands in its place
   */
  public Path checked(Path folder) {
    return OutputPaths.checkedFolder("--out", folder);
  }

  public boolean debug() {
    return debug;
  }
}
