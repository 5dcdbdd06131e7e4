package org.palpate.io.nrrd;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.io.format.FilePattern;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/** Finds the data files that a NRRD header names: one, a list, or a pattern. */
final class NrrdDataFiles {
  private NrrdDataFiles() {}

  /** Returns the files in order; the header's own if the data are attached. */
  static List<Path> of(NrrdHeader header) throws VolumeFormatException {
    if (header.field("data file").isEmpty()) {
      return List.of(header.file());
    }
    String value = header.required("data file");
    List<String> names =
        value.startsWith("LIST") ? header.dataList() : FilePattern.names(header.file(), value);
    if (names.isEmpty()) {
      throw header.refusal("the list of data files is empty");
    }
    List<Path> files = new ArrayList<>();
    for (String name : names) {
      files.add(InputFiles.resolveBeside(header.file(), name));
    }
    requireData(header, files);
    return files;
  }

  /** Refuses a data file that is a header itself. */
  private static void requireData(NrrdHeader header, List<Path> files)
      throws VolumeFormatException {
    for (Path file : files) {
      if (file.equals(header.file().toAbsolutePath().normalize())
          || file.getFileName().toString().toLowerCase(Locale.ROOT).endsWith(".nhdr")) {
        throw header.refusal("the data file '" + file.getFileName() + "' is a header");
      }
    }
  }
}
