package org.palpate.io.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;

/**
 * The right to write a file, which one holder at a time has, in whatever process. A locked file
 * beside it, {@code .NAME.lock}, stands for it. The system ends the lock with the process, however
 * that ends.
 */
public final class FileClaim implements AutoCloseable {
  /**
   * The lock files of this process. It must not open them again: on some systems, closing any
   * channel of a file ends all locks of the process on that file.
   */
  private static final Set<Path> HELD = ConcurrentHashMap.newKeySet();

  private final Path lockFile;
  private final FileChannel channel;

  private FileClaim(Path lockFile, FileChannel channel) {
    this.lockFile = lockFile;
    this.channel = channel;
  }

  /**
   * Claims a file, which need not exist.
   *
   * @return empty if another holder has it
   * @throws IOException if its folder does not exist, may not be written to or does not support
   *     locks
   */
  public static Optional<FileClaim> of(Path file) throws IOException {
    Path lockFile = lockFile(file);
    if (!HELD.add(lockFile)) {
      return Optional.empty();
    }
    Optional<FileClaim> claim = Optional.empty();
    try {
      claim = lock(lockFile);
      return claim;
    } finally {
      if (claim.isEmpty()) {
        HELD.remove(lockFile);
      }
    }
  }

  private static Optional<FileClaim> lock(Path lockFile) throws IOException {
    FileChannel channel =
        FileChannel.open(lockFile, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    boolean isLocked = false;
    try {
      // a holder that has just ended may have deleted the file that was opened
      isLocked = channel.tryLock() != null && Files.exists(lockFile);
    } finally {
      if (!isLocked) {
        channel.close();
      }
    }
    if (!isLocked) {
      return Optional.empty();
    }
    AtomicFile.discardAtEnd(lockFile);
    return Optional.of(new FileClaim(lockFile, channel));
  }

  /** Whether a holder has a file at present. */
  public static boolean isHeld(Path file) {
    Path lockFile = lockFile(file);
    if (HELD.contains(lockFile)) {
      return true;
    }
    try (FileChannel channel = FileChannel.open(lockFile, StandardOpenOption.WRITE)) {
      return channel.tryLock() == null;
    } catch (IOException e) {
      return false; // nobody has locked a file that does not exist
    }
  }

  private static Path lockFile(Path file) {
    Path absolute = file.toAbsolutePath().normalize();
    return absolute.resolveSibling("." + absolute.getFileName() + ".lock");
  }

  /** Gives the file back. */
  @Override
  public void close() throws IOException {
    try {
      Files.deleteIfExists(lockFile);
    } finally {
      channel.close();
      AtomicFile.keepAtEnd(lockFile);
      HELD.remove(lockFile);
    }
  }
}
