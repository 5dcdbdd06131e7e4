package org.palpate.io.format;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.List;

/** Joins the data of several files, the same number of bytes from each. */
public final class ConcatenatedInputStream extends InputStream {
  private final Iterator<Path> rest;
  private final Opener opener;
  private final long bytesPerFile;
  private InputStream part = InputStream.nullInputStream();
  private long left;

  /** Opens the data of one file. */
  @FunctionalInterface
  public interface Opener {
    /** Returns a stream at the first byte of the file's data. */
    InputStream open(Path file) throws IOException;
  }

  /**
   * Joins files; each is opened when the one before has ended.
   *
   * @param bytesPerFile bytes from each file, or {@code Long.MAX_VALUE} for all
   */
  public ConcatenatedInputStream(List<Path> files, Opener opener, long bytesPerFile) {
    rest = files.iterator();
    this.opener = opener;
    this.bytesPerFile = bytesPerFile;
  }

  @Override
  public int read() throws IOException {
    byte[] one = new byte[1];
    return read(one, 0, 1) < 0 ? -1 : one[0] & 0xff;
  }

  @Override
  public int read(byte[] dest, int from, int count) throws IOException {
    int got = left == 0 ? -1 : part.read(dest, from, (int) Math.min(count, left));
    while (got < 0 && (left == 0 || bytesPerFile == Long.MAX_VALUE) && rest.hasNext()) {
      part.close();
      part = opener.open(rest.next());
      left = bytesPerFile;
      got = part.read(dest, from, (int) Math.min(count, left));
    }
    if (got < 0 && left > 0 && bytesPerFile < Long.MAX_VALUE) {
      throw new EOFException("a data file is too short");
    }
    left -= Math.max(got, 0);
    return got;
  }

  @Override
  public void close() throws IOException {
    part.close();
  }
}
