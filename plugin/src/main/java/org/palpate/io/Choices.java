package org.palpate.io;

import java.nio.file.Path;
import java.util.OptionalInt;

/** Refusals that ask the person to choose. */
final class Choices {
  private Choices() {}

  /** There are several time steps or components and none, or one that is not there, was chosen. */
  static VolumeFormatException time(int count, OptionalInt chosen, Path file) {
    String last = Integer.toString(count - 1);
    return new VolumeFormatException(
        chosen.isEmpty()
            ? "it holds " + count + " time steps or components a voxel"
            : "it has no step " + chosen.getAsInt() + ", only 0 to " + last,
        file,
        "choose one with --time 0 to --time " + last);
  }
}
