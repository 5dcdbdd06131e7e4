package org.palpate.io;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Finds the data files that a NRRD header names: one, a list, or a pattern. */
final class NrrdFiles {
  private static final int MOST_FILES = 100_000;

  private NrrdFiles() {}

  /** The files in order; the header's own where the data are attached. */
  static List<Path> of(NrrdHeader header) throws VolumeFormatException {
    if (header.field("data file").isEmpty()) {
      return List.of(header.file());
    }
    String value = header.required("data file");
    List<String> names = value.startsWith("LIST") ? header.dataList() : names(header, value);
    if (names.isEmpty()) {
      throw header.wrong("its list of data files is empty");
    }
    List<Path> files = new ArrayList<>();
    for (String name : names) {
      files.add(Inputs.beside(header.file(), name));
    }
    requireData(header, files);
    return files;
  }

  /** A data file must not be a header that names data in its turn. */
  private static void requireData(NrrdHeader header, List<Path> files)
      throws VolumeFormatException {
    for (Path file : files) {
      if (file.equals(header.file().toAbsolutePath().normalize())
          || file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".nhdr")) {
        throw header.wrong("its data file '" + file.getFileName() + "' is a header");
      }
    }
  }

  /** A pattern is "name%03d.raw min max step", perhaps with a dimension; anything else a name. */
  private static List<String> names(NrrdHeader header, String value) throws VolumeFormatException {
    String[] words = value.split("\\s+");
    boolean isPattern =
        words.length >= 4 && words[0].indexOf('%') >= 0 && words[1].matches("-?[0-9]+");
    return isPattern ? expand(header, words) : List.of(value);
  }

  private static List<String> expand(NrrdHeader header, String[] words)
      throws VolumeFormatException {
    if (!words[0].matches("[^%]*%(0?[1-9])?[du][^%]*")) {
      throw header.wrong("the pattern '" + words[0] + "' has not one number like %03d");
    }
    String format = words[0].replaceFirst("(%(0?[1-9])?)u", "$1d");
    long first = whole(header, words[1]);
    long last = whole(header, words[2]);
    long step = whole(header, words[3]);
    if (step == 0 || (last - first) / step < 0 || (last - first) / step >= MOST_FILES) {
      throw header.wrong("the numbers of its file pattern make no list of files");
    }
    List<String> names = new ArrayList<>();
    for (long n = first; step > 0 ? n <= last : n >= last; n += step) {
      names.add(String.format(Locale.ROOT, format, n));
    }
    return names;
  }

  private static long whole(NrrdHeader header, String text) throws VolumeFormatException {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw header.wrong("'" + text + "' in its file pattern is no whole number");
    }
  }
}
