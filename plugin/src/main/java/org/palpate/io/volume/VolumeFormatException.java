package org.palpate.io.volume;

import java.io.IOException;
import java.nio.file.Path;

/**
 * Reports a volume file that cannot or must not be read. The message is one line, {@code WHAT:
 * WHERE: what to do}, and holds nothing that identifies a patient.
 */
public final class VolumeFormatException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * Creates the exception.
   *
   * @param what what is wrong, with the values that show it
   * @param where the file or the option
   * @param remedy what the user can do
   */
  public VolumeFormatException(String what, String where, String remedy) {
    super(oneLine(what) + ": " + oneLine(where) + ": " + oneLine(remedy));
  }

  /** Creates the exception for a file. */
  public VolumeFormatException(String what, Path where, String remedy) {
    this(what, where.toString(), remedy);
  }

  /** Creates the exception for a file, with its cause, which {@code --debug} shows. */
  public VolumeFormatException(String what, Path where, String remedy, Throwable cause) {
    this(what, where.toString(), remedy, cause);
  }

  /** Creates the exception with its cause, which {@code --debug} shows. */
  public VolumeFormatException(String what, String where, String remedy, Throwable cause) {
    this(what, where, remedy);
    initCause(cause);
  }

  private static String oneLine(String text) {
    StringBuilder line = new StringBuilder(text.length());
    text.codePoints()
        .limit(400)
        .map(c -> Character.isISOControl(c) ? '?' : c)
        .forEach(line::appendCodePoint);
    return line.toString();
  }
}
