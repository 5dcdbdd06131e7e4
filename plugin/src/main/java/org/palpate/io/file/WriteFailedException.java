package org.palpate.io.file;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;

/** Reports that a file cannot be written: the message has the reason, {@link #target} the file. */
public final class WriteFailedException extends IOException {
  private static final long serialVersionUID = 1;

  private final String target;

  WriteFailedException(Path target, IOException cause) {
    super(reason(cause), cause);
    this.target = target.toString();
  }

  /** Returns the system's own reason without the name of the temporary file. */
  static String reason(IOException cause) {
    if (cause instanceof FileSystemException system) {
      String said = system.getReason();
      return said == null ? cause.getClass().getSimpleName().replace("Exception", "") : said;
    }
    return cause.getMessage();
  }

  /** Returns the file that was to be written. */
  public String target() {
    return target;
  }
}
