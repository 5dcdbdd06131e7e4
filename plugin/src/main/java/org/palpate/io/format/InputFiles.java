package org.palpate.io.format;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Locale;
import org.palpate.io.volume.VolumeFormatException;

/** Opens files, and finds those that a header names without leaving its folder. */
public final class InputFiles {
  public static final int BUFFER_BYTES = 1 << 16;

  private InputFiles() {}

  /** A stream over the file from an offset on. */
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

  /** The first bytes of a file, fewer where it is shorter. */
  public static byte[] firstBytes(Path file, int count) throws VolumeFormatException {
    try (InputStream in = Files.newInputStream(file)) {
      return in.readNBytes(count);
    } catch (IOException e) {
      throw unreadableFile(file, e);
    }
  }

  /** The file's length; it must be a plain file that can be read. */
  public static long length(Path file) throws VolumeFormatException {
    try {
      if (!Files.exists(file)) {
        throw new VolumeFormatException("no such file", file, "check the path");
      }
      if (!Files.isRegularFile(file)) {
        throw new VolumeFormatException("not a plain file", file, "name a file");
      }
      return Files.size(file);
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw unreadableFile(file, e);
    }
  }

  /** Says that the system does not let the file be read. */
  public static VolumeFormatException unreadableFile(Path file, IOException e) {
    String what = e instanceof NoSuchFileException ? "no such file" : "cannot be read";
    return new VolumeFormatException(
        what, file, "check that it exists and that you may read it", e);
  }

  /**
   * The file that a header names, which must lie in the header's folder or below, links followed.
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
            "its data file '" + name + "' lies outside its folder",
            header,
            "put the data beside the header and name it without a path");
      }
      length(real);
      return real;
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw new VolumeFormatException(
          "its data file '" + name + "' is not there", header, "put it beside the header", e);
    }
  }

  private static Path resolve(Path header, Path folder, String name) throws VolumeFormatException {
    Path relative;
    try {
      relative = Path.of(name);
    } catch (IllegalArgumentException e) {
      throw new VolumeFormatException(
          "its data file '" + name + "' is no file name", header, "name a file beside it", e);
    }
    // both kinds of separator, whichever system this is
    boolean climbs = name.replace('\\', '/').matches("(.*/)?\\.\\.(/.*)?|/.*|[A-Za-z]:.*");
    if (relative.isAbsolute() || climbs || name.isBlank()) {
      throw new VolumeFormatException(
          "its data file '" + name + "' lies outside its folder",
          header,
          "put the data beside the header and name it without a path");
    }
    return folder.resolve(relative);
  }

  /** Returns whether the name of a file ends in one of some endings, in either case. */
  public static boolean hasEnding(Path file, String... endings) {
    String name = file.getFileName().toString().toLowerCase(Locale.ROOT);
    return Arrays.stream(endings).anyMatch(name::endsWith);
  }
}
