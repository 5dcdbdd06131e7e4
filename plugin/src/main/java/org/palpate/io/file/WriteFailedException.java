package org.palpate.io.file;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.nio.file.Path;

/** A file could not be written; the message says why, {@link #target} which. */
public final class WriteFailedException extends IOException {
  private static final long serialVersionUID = 1;

  private final String target;

  WriteFailedException(Path target, IOException cause) {
    super(reason(cause), cause);
    this.target = target.toString();
  }

  /** The system's own words, without the name of the file beside the target. */
  private static String reason(IOException cause) {
    if (cause instanceof FileSystemException system) {
      String said = system.getReason();
      return said == null ? cause.getClass().getSimpleName().replace("Exception", "") : said;
    }
    return cause.getMessage();
  }

  /** The file that was to be. */
  public String target() {
    return target;
  }
}
