package org.palpate.io.raw;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/** Finds the slices of a raw volume that is a folder of files, in the order of their numbers. */
final class RawSliceFiles {
  private static final Pattern LAST_NUMBER = Pattern.compile("(\\d{1,9})\\D*$");

  private RawSliceFiles() {}

  /** The files that have a number in their names, by the last of it. */
  static List<Path> files(Path folder) throws VolumeFormatException {
    List<Path> files = new ArrayList<>();
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(folder)) {
      for (Path entry : entries) {
        if (number(entry) >= 0 && Files.isRegularFile(entry)) {
          files.add(entry);
        }
      }
    } catch (IOException e) {
      throw InputFiles.unreadable(folder, e);
    }
    if (files.isEmpty()) {
      throw new VolumeFormatException(
          "it holds no numbered files", folder, "number the slices, as in slice.1, slice.2");
    }
    files.sort(
        Comparator.comparingInt(RawSliceFiles::number).thenComparing(Comparator.naturalOrder()));
    return files;
  }

  private static int number(Path file) {
    Matcher matcher = LAST_NUMBER.matcher(file.getFileName().toString());
    return matcher.find() ? Integer.parseInt(matcher.group(1)) : -1;
  }
}
