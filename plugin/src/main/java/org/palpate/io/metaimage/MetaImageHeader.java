package org.palpate.io.metaimage;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.palpate.io.format.HeaderLineReader;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The fields of a MetaImage header as text.
 *
 * <p>Source: MetaIO documentation, itk.org/Wiki/MetaIO/Documentation.
 *
 * @param file its path
 * @param fields values by key, keys as written
 * @param dataList file names that follow {@code ElementDataFile = LIST}
 * @param dataOffset offset of LOCAL data
 */
record MetaImageHeader(
    Path file, Map<String, String> fields, List<String> dataList, long dataOffset) {
  private static final String LAST_KEY = "ElementDataFile";

  /** Returns whether a file with these first bytes is a MetaImage file. */
  static boolean isMetaImage(byte[] start) {
    String text = new String(start, StandardCharsets.ISO_8859_1);
    return text.matches("(?s)\\s*(ObjectType|NDims|Comment)\\s*=.*");
  }

  /** Reads the header at the start of a file. */
  static MetaImageHeader read(Path file) throws VolumeFormatException {
    Map<String, String> fields = new HashMap<>();
    List<String> list = new ArrayList<>();
    try (InputStream in = InputFiles.open(file, 0)) {
      HeaderLineReader lines = new HeaderLineReader(in, file);
      String line = lines.next();
      for (; line != null; line = lines.next()) {
        if (!line.isBlank()) {
          parseLine(line, file, fields);
        }
        if (fields.containsKey(LAST_KEY)) {
          break;
        }
      }
      MetaImageHeader header = new MetaImageHeader(file, fields, list, lines.bytesRead());
      if (header.required(LAST_KEY).startsWith("LIST")) {
        for (line = lines.next(); line != null && !line.isBlank(); line = lines.next()) {
          list.add(line.strip());
        }
      }
      return header;
    } catch (VolumeFormatException e) {
      throw e;
    } catch (IOException e) {
      throw InputFiles.unreadableFile(file, e);
    }
  }

  private static void parseLine(String line, Path file, Map<String, String> fields)
      throws VolumeFormatException {
    int equals = line.indexOf('=');
    if (equals < 1) {
      String shown = line.length() > 60 ? line.substring(0, 60) + "..." : line;
      throw new VolumeFormatException(
          "the line '" + shown + "' of the header is no field", file, "export the file again");
    }
    String key = line.substring(0, equals).strip();
    String value = line.substring(equals + 1).strip();
    if (key.equals("ObjectType") && !value.equalsIgnoreCase("Image")) {
      throw new VolumeFormatException(
          "the ObjectType \"" + value + "\" is no image",
          file,
          "give the image from which it was made (ObjectType = Image)");
    }
    fields.put(key, value);
  }

  /**
   * Returns the value of a key.
   *
   * @throws VolumeFormatException if it is absent
   */
  String required(String key) throws VolumeFormatException {
    String value = fields.get(key);
    if (value == null) {
      throw refusal("the header has no '" + key + "'");
    }
    return value;
  }

  /** Returns the value of the first key that is present, or the fallback. */
  String first(String fallback, String... keys) {
    for (String key : keys) {
      if (fields.containsKey(key)) {
        return fields.get(key);
      }
    }
    return fallback;
  }

  /** Whether the first key that is present says True; false if all are absent. */
  boolean isTrue(String... keys) {
    String value = first("False", keys).toLowerCase(Locale.ROOT);
    return value.startsWith("t") || value.startsWith("y") || value.equals("1");
  }

  /** Returns an exception that names the header. */
  VolumeFormatException refusal(String what) {
    return new VolumeFormatException(what, file, "correct the header, or export the file again");
  }
}
