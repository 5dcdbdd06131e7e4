package org.palpate.app.options;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The option that asks for an assessment of a session. */
public final class AssessOptions {
  /** The page of an assessment. */
  public static final String PAGE = "assessment.html";

  /** The values of an assessment. */
  public static final String VALUES = "assessment.json";

  /** The table of segments. */
  public static final String SEGMENTS = "segments.csv";

  /** The table of the course of force and position. */
  public static final String COURSE = "course.csv";

  /** The table of the spectrum of the hand's motion. */
  public static final String TREMOR = "tremor.csv";

  /** The table of what the hand held. */
  public static final String HOLDS = "holds.csv";

  private static final List<String> FILES = List.of(PAGE, VALUES, SEGMENTS, COURSE, TREMOR, HOLDS);

  @Option(
      names = "--assess",
      paramLabel = "DIR",
      description = {
        "Assesses the session for training and writes a page, values and tables into DIR: path and"
            + " time, force and contacts of each segment, tremor, what was held, cut and placed."
      })
  private Path folder;

  /**
   * Checks the files of the assessment, if one is wanted.
   *
   * @param inputs files that must not be replaced
   * @throws PalpateException exit code 2, if a file has the folder's name or an input lies there
   */
  public void check(List<Path> inputs) {
    if (folder != null && Files.isDirectory(OutputPaths.checkedFolder("--assess", folder))) {
      targets().forEach(file -> OutputPaths.checked("--assess", file, inputs));
    }
  }

  /** Returns the folder, if an assessment is wanted. */
  public Optional<Path> folder() {
    return Optional.ofNullable(folder);
  }

  /** Returns the files that an assessment writes; none if it is not wanted. */
  public List<Path> targets() {
    return folder == null ? List.of() : FILES.stream().map(folder::resolve).toList();
  }
}
