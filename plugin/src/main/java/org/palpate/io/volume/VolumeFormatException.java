package org.palpate.io.volume;

import java.io.IOException;
import java.nio.file.Path;

/**
 * A volume file that cannot be read, or that must not be. The message is one line for a person,
 * {@code WHAT: WHERE: what to do}, and holds nothing from a header that names a patient.
 */
public final class VolumeFormatException extends IOException {
  private static final long serialVersionUID = 1L;

  /**
   * @param what what is wrong, with the values that show it
   * @param where the file or the option
   * @param remedy what the person can do about it
   */
  public VolumeFormatException(String what, String where, String remedy) {
    super(oneLine(what) + ": " + oneLine(where) + ": " + oneLine(remedy));
  }

  public VolumeFormatException(String what, Path where, String remedy) {
    this(what, where.toString(), remedy);
  }

  /** The same with the exception behind it, for {@code --debug}. */
  public VolumeFormatException(String what, Path where, String remedy, Throwable cause) {
    this(what, where.toString(), remedy, cause);
  }

  /** The same with the exception behind it, for {@code --debug}. */
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
