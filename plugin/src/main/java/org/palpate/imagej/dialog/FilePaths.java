package org.palpate.imagej.dialog;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.palpate.imagej.stack.TouchRefusedException;

/** Paths as people write them into dialogs. */
public final class FilePaths {
  private FilePaths() {}

  /**
   * The path that a text names.
   *
   * @param what it is to be, for people
   * @throws TouchRefusedException where it is empty, or no name for a file on this system
   */
  public static Path of(String what, String text) throws TouchRefusedException {
    if (text.isBlank()) {
      throw new TouchRefusedException("It is not said which " + what + " is meant.");
    }
    try {
      return Path.of(text.strip());
    } catch (InvalidPathException e) {
      throw new TouchRefusedException("This names no " + what + ": " + text);
    }
  }
}
