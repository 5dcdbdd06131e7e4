package org.palpate.io.format;

import java.nio.file.Path;
import java.util.List;
import java.util.OptionalInt;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;

/** Checks the read options against what a file has to choose from. */
public final class ReadOptionChecks {
  private ReadOptionChecks() {}

  /**
   * Returns the time step or component to read, from 0. If there are several, a note reports the
   * choice.
   *
   * @param count how many there are, at least 1
   * @throws VolumeFormatException if there are several and none, or one that does not exist, was
   *     chosen
   */
  public static int chosenStep(int count, ReadOptions options, Path file, List<String> notes)
      throws VolumeFormatException {
    return chosenStep(count, count + " time steps or components", options, file, notes);
  }

  /**
   * Returns the step to read, from 0. If there are several, a note reports the choice.
   *
   * @param count how many there are, at least 1
   * @param what what there is to choose from, in words: "3 times of 5 slices"
   * @throws VolumeFormatException if there are several and none, or one that does not exist, was
   *     chosen
   */
  public static int chosenStep(
      int count, String what, ReadOptions options, Path file, List<String> notes)
      throws VolumeFormatException {
    OptionalInt chosen = options.timeStep();
    if (count == 1 && chosen.orElse(0) == 0) {
      return 0;
    }
    if (chosen.isEmpty() || chosen.getAsInt() < 0 || chosen.getAsInt() >= count) {
      throw refusal(count, what, chosen, file);
    }
    notes.add("step " + chosen.getAsInt() + " of " + count + ", counted from 0");
    return chosen.getAsInt();
  }

  private static VolumeFormatException refusal(
      int count, String what, OptionalInt chosen, Path file) {
    if (count == 1) {
      return new VolumeFormatException(
          "the file has a single time step, no step " + chosen.getAsInt(),
          file,
          "leave --time out");
    }
    String last = Integer.toString(count - 1);
    return new VolumeFormatException(
        chosen.isEmpty()
            ? "the file has " + what
            : "the file has no step " + chosen.getAsInt() + ", only 0 to " + last,
        file,
        "choose one with --time 0 to --time " + last);
  }

  /**
   * Refuses the choice of a series for a single file.
   *
   * @throws VolumeFormatException if a series was chosen
   */
  public static void refuseSeriesOption(ReadOptions options, Path file)
      throws VolumeFormatException {
    if (options.series().isPresent()) {
      throw new VolumeFormatException(
          "a single file has no series to choose from, unlike a folder of DICOM files",
          file,
          "leave --series out");
    }
  }
}
