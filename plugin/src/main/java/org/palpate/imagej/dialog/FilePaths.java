package org.palpate.imagej.dialog;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.palpate.imagej.stack.TouchRefusedException;

/** Parses the paths that users write into dialogs. */
public final class FilePaths {
  private FilePaths() {}

  /**
   * Parses a path.
   *
   * @param what the kind of file, for the error message
   * @throws TouchRefusedException if the text is empty or not a valid path
   */
  public static Path of(String what, String text) throws TouchRefusedException {
    if (text.isBlank()) {
      throw new TouchRefusedException("The " + what + " is missing: enter its path.");
    }
    try {
      return Path.of(text.strip());
    } catch (InvalidPathException e) {
      throw new TouchRefusedException("This is not a valid path of a " + what + ": " + text);
    }
  }
}
