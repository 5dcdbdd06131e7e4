package org.palpate.imagej;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;

/** Paths as people write them into dialogs. */
final class FilePaths {
  private FilePaths() {}

  /**
   * The path that a text names.
   *
   * @param what it is to be, for people
   * @throws StackRefused where it is empty, or no name for a file on this system
   */
  static Path of(String what, String text) throws StackRefused {
    if (text.isBlank()) {
      throw new StackRefused("It is not said which " + what + " is meant.");
    }
    try {
      return Path.of(text.strip());
    } catch (InvalidPathException e) {
      throw new StackRefused("This names no " + what + ": " + text);
    }
  }
}
