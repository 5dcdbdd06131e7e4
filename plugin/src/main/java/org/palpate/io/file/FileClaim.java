package org.palpate.io.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.Objects;
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
    try {
      return claim(lockFile(file));
    } catch (FileSystemException e) {
      // some of these exceptions have nothing but a file as their message
      throw new FileSystemException(file.toString(), null, WriteFailedException.reason(e));
    }
  }

  private static Optional<FileClaim> claim(Path lockFile) throws IOException {
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
    create(lockFile);
    Object key;
    FileChannel channel;
    try {
      key = key(lockFile);
      channel = FileChannel.open(lockFile, StandardOpenOption.WRITE);
    } catch (NoSuchFileException e) {
      return Optional.empty(); // a holder has just ended
    }
    boolean isLocked = false;
    try {
      isLocked = channel.tryLock() != null && isStill(lockFile, key);
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

  private static void create(Path lockFile) throws IOException {
    try {
      Files.createFile(lockFile);
    } catch (FileAlreadyExistsException e) {
      // a holder has it, or was killed
    }
  }

  /** Returns the identity of a file; null if the system has none. */
  private static Object key(Path file) throws IOException {
    return Files.readAttributes(file, BasicFileAttributes.class).fileKey();
  }

  /**
   * Whether a name still stands for a file. A holder that has just ended may have deleted the file
   * that was opened, and the next one may have created another.
   */
  private static boolean isStill(Path lockFile, Object key) throws IOException {
    try {
      return Objects.equals(key(lockFile), key);
    } catch (NoSuchFileException e) {
      return false;
    }
  }

  /** Whether a holder has a file at present. */
  public static boolean isHeld(Path file) {
    try {
      Path lockFile = lockFile(file);
      return HELD.contains(lockFile) || isLocked(lockFile);
    } catch (IOException e) {
      return false; // nobody has locked a file that does not exist
    }
  }

  private static boolean isLocked(Path lockFile) throws IOException {
    try (FileChannel channel = FileChannel.open(lockFile, StandardOpenOption.WRITE)) {
      return channel.tryLock() == null;
    }
  }

  /** Returns the lock file, which is the same for every name of the folder, also through links. */
  private static Path lockFile(Path file) throws IOException {
    Path absolute = file.toAbsolutePath();
    return absolute.getParent().toRealPath().resolve("." + absolute.getFileName() + ".lock");
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
