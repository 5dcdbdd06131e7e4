package org.palpate.io.nrrd;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.io.format.HeaderLineReader;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The fields of a NRRD header as text.
 *
 * <p>Source: Definition of NRRD File Format, teem.sourceforge.net/nrrd/format.html.
 *
 * @param file its path
 * @param fields values by field name, in lower case and with single spaces
 * @param keyValues pairs to which the format gives no meaning
 * @param dataList file names that follow {@code data file: LIST}
 * @param dataOffset offset of attached data
 */
record NrrdHeader(
    Path file,
    Map<String, String> fields,
    Map<String, String> keyValues,
    List<String> dataList,
    long dataOffset) {
  private static final String MAGIC = "NRRD000";

  private static final Map<String, String> OTHER_NAMES =
      Map.of(
          "datafile", "data file",
          "byteskip", "byte skip",
          "lineskip", "line skip",
          "centers", "centerings",
          "axismins", "axis mins",
          "axismaxs", "axis maxs");

  /** Returns whether a file with these first bytes is a NRRD file. */
  static boolean isNrrd(byte[] start) {
    return new String(start, StandardCharsets.ISO_8859_1).startsWith(MAGIC);
  }

  /** Reads the header at the start of a file. */
  static NrrdHeader read(Path file) throws VolumeFormatException {
    NrrdHeader header =
        new NrrdHeader(file, new HashMap<>(), new HashMap<>(), new ArrayList<>(), 0);
    try (InputStream in = InputFiles.open(file, 0)) {
      HeaderLineReader lines = new HeaderLineReader(in, file);
      String magic = lines.next();
      if (magic == null || !magic.matches("NRRD000[1-5]\\s*")) {
        throw header.refusal("the first line is not NRRD0001 to NRRD0005");
      }
      boolean listFollows = false;
      for (String line = lines.next(); line != null && !line.isEmpty(); line = lines.next()) {
        if (listFollows) {
          header.dataList.add(line.strip());
        } else {
          listFollows = header.parseLine(line);
        }
      }
      return new NrrdHeader(
          file, header.fields, header.keyValues, header.dataList, lines.bytesRead());
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw InputFiles.unreadableFile(file, e);
    }
  }

  /** Returns the value of a field. */
  Optional<String> field(String name) {
    return Optional.ofNullable(fields.get(name));
  }

  /**
   * Returns the value of a field.
   *
   * @throws VolumeFormatException if it is absent
   */
  String required(String name) throws VolumeFormatException {
    return field(name).orElseThrow(() -> refusal("the header has no '" + name + "'"));
  }

  /** Returns the words of a field, separated by white space; none if it is absent. */
  String[] words(String name) {
    String value = fields.getOrDefault(name, "").strip();
    return value.isEmpty() ? new String[0] : value.split("\\s+");
  }

  /** Returns an exception that names the header. */
  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(what, file, "correct the header, or export the file again");
  }

  /** Parses a line, and returns whether file names follow it. */
  private boolean parseLine(String line) throws VolumeFormatException {
    if (line.startsWith("#")) {
      return false;
    }
    int pair = line.indexOf(":=");
    int field = line.indexOf(": ");
    if (field < 0 && line.endsWith(":")) {
      field = line.length() - 1;
    }
    if (pair > 0 && (field < 0 || pair < field)) {
      keyValues.put(line.substring(0, pair), line.substring(pair + 2));
      return false;
    }
    if (field < 1) {
      throw refusal("the line '" + shortened(line) + "' of the header is no field");
    }
    return putField(fieldName(line.substring(0, field)), line.substring(field + 1).strip());
  }

  private boolean putField(String name, String value) throws VolumeFormatException {
    if (fields.put(name, value) != null) {
      throw refusal("the field '" + shortened(name) + "' occurs twice in the header");
    }
    return name.equals("data file") && value.startsWith("LIST");
  }

  private static String fieldName(String text) {
    String name = text.strip().toLowerCase(Locale.ROOT).replaceAll("\\s+", " ");
    return OTHER_NAMES.getOrDefault(name, name);
  }

  private static String shortened(String text) {
    return text.length() <= 60 ? text : text.substring(0, 60) + "...";
  }
}
