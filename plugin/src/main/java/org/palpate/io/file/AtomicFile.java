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
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * Writes a file under a temporary name beside its target and then moves it over the target. A
 * failure leaves the target as it was. For one thread.
 *
 * <p>A target that exists and is no regular file (a pipe, a terminal) is written directly. Any
 * failure of the disk is a {@link WriteFailedException} that names the target.
 */
public final class AtomicFile implements AutoCloseable {
  /** Temporary files that are neither committed nor discarded, and lock files. */
  private static final Set<Path> UNFINISHED = ConcurrentHashMap.newKeySet();

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
    // a link stays; the file that it points to is replaced
    this.target = Files.isRegularFile(target) ? target.toRealPath() : target.toAbsolutePath();
    written = isDirect(target) ? this.target : beside(this.target);
    if (!written.equals(this.target)) {
      UNFINISHED.add(written);
    }
    try {
      stream = new BufferedOutputStream(new NamingStream(open()), 1 << 16);
    } catch (IOException e) {
      UNFINISHED.remove(written);
      throw new WriteFailedException(asked, e);
    }
  }

  /** Whether a target exists and is no regular file, so that it is written directly. */
  public static boolean isDirect(Path target) {
    return Files.exists(target) && !Files.isRegularFile(target);
  }

  /** Lets {@link #discardUnfinished} delete another file too. */
  static void discardAtEnd(Path file) {
    UNFINISHED.add(file);
  }

  /** Takes {@link #discardAtEnd} back. */
  static void keepAtEnd(Path file) {
    UNFINISHED.remove(file);
  }

  /** Deletes the temporary files of all open files. For the end of the process alone. */
  public static void discardUnfinished() {
    for (Path file : UNFINISHED) {
      try {
        Files.deleteIfExists(file);
      } catch (IOException e) {
        // The process ends; nothing else can be done about it.
      }
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
    UNFINISHED.remove(written);
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
        UNFINISHED.remove(written);
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
