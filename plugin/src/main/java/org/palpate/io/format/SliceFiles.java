package org.palpate.io.format;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.io.volume.VolumeFormatException;

/** Finds the slices of a volume that is a folder of numbered files. */
public final class SliceFiles {
  private static final Pattern LAST_NUMBER = Pattern.compile("(\\d{1,9})\\D*$");

  private SliceFiles() {}

  /**
   * Returns the files with a number in their names, sorted by the last number of each name.
   *
   * @throws VolumeFormatException if the folder has no such file or cannot be read
   */
  public static List<Path> of(Path folder) throws VolumeFormatException {
    List<Path> files = new ArrayList<>();
    for (Path entry : InputFiles.entries(folder)) {
      if (number(entry) >= 0 && Files.isRegularFile(entry)) {
        files.add(entry);
      }
    }
    if (files.isEmpty()) {
      throw new VolumeFormatException(
          "the folder has no numbered files", folder, "number the slices, as in slice.1, slice.2");
    }
    files.sort(
        Comparator.comparingInt(SliceFiles::number).thenComparing(Comparator.naturalOrder()));
    return files;
  }

  private static int number(Path file) {
    Matcher matcher = LAST_NUMBER.matcher(file.getFileName().toString());
    return matcher.find() ? Integer.parseInt(matcher.group(1)) : -1;
  }
}
