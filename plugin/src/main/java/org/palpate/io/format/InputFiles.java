package org.palpate.io.format;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Opens input files, and finds the files that a header names without leaving the header's folder.
 */
public final class InputFiles {
  public static final int BUFFER_BYTES = 1 << 16;

  private InputFiles() {}

  /** Opens a buffered stream at an offset of a file. */
  public static InputStream open(Path file, long offset) throws IOException {
    InputStream in = Files.newInputStream(file);
    try {
      in.skipNBytes(offset);
      return new BufferedInputStream(in, BUFFER_BYTES);
    } catch (IOException e) {
      in.close();
      throw e;
    }
  }

  /** Returns the first bytes of a file; fewer if the file is shorter. */
  public static byte[] firstBytes(Path file, int count) throws VolumeFormatException {
    try (InputStream in = Files.newInputStream(file)) {
      return in.readNBytes(count);
    } catch (IOException e) {
      throw unreadableFile(file, e);
    }
  }

  /**
   * Returns the files and folders of a folder, sorted, because their order differs between systems.
   *
   * @throws VolumeFormatException if the folder cannot be read
   */
  public static List<Path> entries(Path folder) throws VolumeFormatException {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
      entries.forEach(found::add);
    } catch (DirectoryIteratorException e) {
      throw unreadableFile(folder, e.getCause());
    } catch (IOException e) {
      throw unreadableFile(folder, e);
    }
    Collections.sort(found);
    return found;
  }

  /**
   * Returns the length of a file in bytes.
   *
   * @throws VolumeFormatException if it is no regular file or cannot be read
   */
  public static long length(Path file) throws VolumeFormatException {
    try {
      if (!Files.exists(file)) {
        throw new VolumeFormatException("no such file", file, "check the path");
      }
      if (!Files.isRegularFile(file)) {
        throw new VolumeFormatException("not a regular file", file, "name a file");
      }
      return Files.size(file);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw unreadableFile(file, e);
    }
  }

  /**
   * Returns the exception for a file that is too short for its header.
   *
   * @param promised bytes of data that the header promises
   * @param found bytes of data that the file has
   * @param encoding the compression of the bytes found; empty if there is none
   */
  public static VolumeFormatException truncatedFile(
      Path file, double promised, double found, String encoding) {
    return new VolumeFormatException(
        "the header promises "
            + NumberText.count(promised)
            + " bytes of data but the file has "
            + NumberText.count(Math.max(0, found))
            + (encoding.isEmpty() ? "" : " (" + encoding + ")"),
        file,
        "copy the file again; if that does not help, export it again");
  }

  /** Returns the exception for a file that the system does not let us read. */
  public static VolumeFormatException unreadableFile(Path file, IOException e) {
    String what = e instanceof NoSuchFileException ? "no such file" : "cannot be read";
    return new VolumeFormatException(
        what, file, "check that it exists and that you may read it", e);
  }

  /**
   * Returns the file that a header names. It must be in the header's folder or below, also after
   * links are followed.
   *
   * @param name as the header has it
   */
  public static Path resolveBeside(Path header, String name) throws VolumeFormatException {
    Path folder = header.toAbsolutePath().getParent();
    Path file = resolve(header, folder, name);
    try {
      Path real = file.toRealPath();
      if (!file.normalize().startsWith(folder.normalize())
          || !real.startsWith(folder.toRealPath())) {
        throw new VolumeFormatException(
            "the data file '" + name + "' is outside its folder",
            header,
            "put the data file into the folder of the header and name it without a path");
      }
      length(real);
      return real;
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the data file '" + name + "' is missing",
          header,
          "put it into the folder of the header",
          e);
    }
  }

  private static Path resolve(Path header, Path folder, String name) throws VolumeFormatException {
    Path relative;
    try {
      relative = Path.of(name);
    } catch (IllegalArgumentException e) {
      throw new VolumeFormatException(
          "the data file '" + name + "' is no valid file name", header, "correct the name", e);
    }
    if (relative.isAbsolute() || name.isBlank() || leavesFolder(name.replace('\\', '/'))) {
      throw new VolumeFormatException(
          "the data file '" + name + "' is outside its folder",
          header,
          "put the data file into the folder of the header and name it without a path");
    }
    return folder.resolve(relative);
  }

  /** Whether a path, with / on every system, starts elsewhere or leads above its start. */
  private static boolean leavesFolder(String path) {
    return path.matches("/.*|[A-Za-z]:.*") || Path.of(path).normalize().startsWith("..");
  }

  /** Returns whether the name of a file ends in one of some endings, in upper or lower case. */
  public static boolean hasEnding(Path file, String... endings) {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    return Arrays.stream(endings).anyMatch(name::endsWith);
  }
}
