package org.palpate.io.format;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.io.volume.VolumeFormatException;

/** Expands the file patterns of NRRD and MetaImage headers. */
public final class FilePattern {
  private static final int MAX_FILES = 100_000;

  private FilePattern() {}

  /**
   * Returns the names that a pattern such as "name%03d.raw min max step" stands for. Any other
   * value is a single name.
   */
  public static List<String> names(Path header, String value) throws VolumeFormatException {
    String[] words = value.split("\\s+");
    boolean isPattern =
        words.length >= 4 && words[0].indexOf('%') >= 0 && words[1].matches("-?[0-9]+");
    return isPattern ? expand(header, words) : List.of(value);
  }

  private static List<String> expand(Path header, String[] words) throws VolumeFormatException {
    if (!words[0].matches("[^%]*%(0?[1-9])?[du][^%]*")) {
      throw refusal(header, "the pattern '" + words[0] + "' needs exactly one number like %03d");
    }
    String format = words[0].replaceFirst("(%(0?[1-9])?)u", "$1d");
    long first = integer(header, words[1]);
    long last = integer(header, words[2]);
    long step = integer(header, words[3]);
    if (step == 0 || (last - first) / step < 0 || (last - first) / step >= MAX_FILES) {
      throw refusal(header, "the numbers of its file pattern give no list of files");
    }
    List<String> names = new ArrayList<>();
    for (long n = first; step > 0 ? n <= last : n >= last; n += step) {
      names.add(String.format(Locale.ROOT, format, n));
    }
    return names;
  }

  private static long integer(Path header, String text) throws VolumeFormatException {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw refusal(header, "'" + text + "' in the file pattern is no integer");
    }
  }

  private static VolumeFormatException refusal(Path header, String what) {
    return new VolumeFormatException(
        what, header, "list the names of the data files instead (LIST)");
  }
}
