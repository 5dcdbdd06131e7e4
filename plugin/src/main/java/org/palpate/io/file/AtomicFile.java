package org.palpate.io.file;

import java.io.BufferedOutputStream;
import java.io.FilterOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;

/**
 * Writes a file under a temporary name beside its target and then moves it over the target. A
 * failure leaves the target as it was. For one thread.
 *
 * <p>A target that exists and is no regular file (a pipe, a terminal) is written directly. Any
 * failure of the disk is a {@link WriteFailedException} that names the target.
 */
public final class AtomicFile implements AutoCloseable {
  private final Path asked;
  private final Path target;
  private final Path written;
  private final OutputStream stream;
  private boolean closed;

  /**
   * Opens the temporary file.
   *
   * @throws WriteFailedException if the folder does not exist or may not be written to
   */
  public AtomicFile(Path target) throws IOException {
    asked = target;
    boolean isNoPlainFile = Files.exists(target) && !Files.isRegularFile(target);
    // a link stays; the file that it points to is replaced
    this.target = Files.isRegularFile(target) ? target.toRealPath() : target.toAbsolutePath();
    written = isNoPlainFile ? this.target : beside(this.target);
    try {
      stream = new BufferedOutputStream(new NamingStream(open()), 1 << 16);
    } catch (IOException e) {
      throw new WriteFailedException(asked, e);
    }
  }

  /** Replaces a file by a text in UTF-8. */
  public static void write(Path target, CharSequence text) throws IOException {
    try (AtomicFile out = new AtomicFile(target)) {
      out.stream().write(text.toString().getBytes(StandardCharsets.UTF_8));
      out.commit();
    }
  }

  private static Path beside(Path target) {
    long process = ProcessHandle.current().pid();
    return target.resolveSibling(
        "." + target.getFileName() + "." + process + "-" + System.nanoTime() + ".new");
  }

  private OutputStream open() throws IOException {
    return written.equals(target)
        ? Files.newOutputStream(written)
        : Files.newOutputStream(written, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /** Returns the buffered stream to write to, which {@link #commit} and {@link #close} close. */
  public OutputStream stream() {
    return stream;
  }

  /** Closes the file and moves it over the target. */
  public void commit() throws IOException {
    stream.close();
    if (!written.equals(target)) {
      try {
        move();
      } catch (IOException e) {
        throw new WriteFailedException(asked, e);
      }
    }
    closed = true;
  }

  private void move() throws IOException {
    try {
      Files.move(
          written, target, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    } catch (AtomicMoveNotSupportedException e) {
      Files.move(written, target, StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Discards what was written, unless it was committed. */
  @Override
  public void close() throws IOException {
    if (closed) {
      return;
    }
    closed = true;
    try {
      stream.close();
    } finally {
      if (!written.equals(target)) {
        Files.deleteIfExists(written);
      }
    }
  }

  /** Names the target in every failure. */
  private final class NamingStream extends FilterOutputStream {
    NamingStream(OutputStream file) {
      super(file);
    }

    @Override
    public void write(int b) throws IOException {
      try {
        out.write(b);
      } catch (IOException e) {
        throw new WriteFailedException(asked, e);
      }
    }

    @Override
    public void write(byte[] bytes, int from, int count) throws IOException {
      try {
        out.write(bytes, from, count);
      } catch (IOException e) {
        throw new WriteFailedException(asked, e);
      }
    }
  }
}
