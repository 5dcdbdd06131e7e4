package org.palpate.app.options;

import java.nio.file.Path;
import java.util.Optional;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The options of recordings. */
public final class RecordOptions {
  @Option(
      names = "--record",
      paramLabel = "T.csv",
      description = {
        "Records what the device sends, for palpate replay; changes of voxels into T.edits.csv, and"
            + " poses of bodies into T.poses.csv."
      })
  private Path file;

  @Option(
      names = "--record-fields",
      description =
          "With --record and --elastic: also records the updates of elastic segments into"
              + " T.fields.csv, so that replay --fields repeats the session bit for bit.")
  private boolean fields;

  /** Returns the file to record into, if any. */
  public Optional<Path> file() {
    return Optional.ofNullable(file);
  }

  /** Whether updates of elastic segments are recorded too. */
  public boolean hasFields() {
    return fields;
  }

  /**
   * Refuses to record updates without a recording or without elastic segments.
   *
   * @param elastic whether a segment is elastic
   * @throws PalpateException exit code 2
   */
  public void check(boolean elastic) {
    if (fields && file == null) {
      throw PalpateException.wrongUse(
          "updates are recorded beside the samples", "--record-fields", "add --record T.csv");
    }
    if (fields && !elastic) {
      throw PalpateException.wrongUse(
          "no segment is elastic",
          "--record-fields",
          "add --elastic NAME=young:PA, or leave it out");
    }
  }
}
