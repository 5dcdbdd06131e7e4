package org.palpate.io.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.io.format.HeaderLineReader;
import org.palpate.io.volume.VolumeFormatException;

/**
 * The header of a PLY file.
 *
 * @param format {@code ascii}, {@code binary_little_endian} or {@code binary_big_endian}
 * @param elements the elements in the order of their data
 */
record PlyHeader(String format, List<Element> elements) {

  /** The types of a number; each has two names. */
  enum NumberType {
    INT8(1),
    UINT8(1),
    INT16(2),
    UINT16(2),
    INT32(4),
    UINT32(4),
    FLOAT32(4),
    FLOAT64(8);

    final int bytes;

    NumberType(int bytes) {
      this.bytes = bytes;
    }
  }

  /**
   * A property of an element.
   *
   * @param countType the type of the length of a list, or null if it is a single number
   */
  record Property(String name, NumberType type, NumberType countType) {
    boolean isList() {
      return countType != null;
    }

    /** Whether a list of this name holds the corners of a face. */
    boolean isCorners() {
      return name.equals("vertex_index") || name.equals("vertex_indices");
    }

    /** Returns the axis of a coordinate of this name, 0 for x; -1 if it is none. */
    int axis() {
      return name.length() == 1 ? "xyz".indexOf(name) : -1;
    }
  }

  /** A kind of element, such as vertex or face, and its number. */
  record Element(String name, long count, List<Property> properties) {
    /** Returns the bytes of the shortest element in a binary file. */
    long leastBytes() {
      long sum = 0;
      for (Property property : properties) {
        sum += property.isList() ? property.countType().bytes : property.type().bytes;
      }
      return sum;
    }
  }

  boolean isText() {
    return format.equals("ascii");
  }

  /** Reads a header and leaves the stream at the first byte of the data. */
  static PlyHeader read(InputStream in, Path file) throws IOException {
    HeaderLineReader lines = new HeaderLineReader(in, file);
    String first = lines.next();
    if (first == null || !first.strip().equals("ply")) {
      throw refusal("the file does not begin with the word ply", file);
    }
    String format = "";
    List<Element> elements = new ArrayList<>();
    while (true) {
      String line = lines.next();
      if (line == null) {
        throw MeshFiles.tooShort(file, null);
      }
      String[] words = line.strip().split("\\s+", -1);
      switch (words[0]) {
        case "format" -> format = format(words, file);
        case "element" -> elements.add(element(words, line, file));
        case "property" -> addProperty(words, line, elements, file);
        case "end_header" -> {
          return new PlyHeader(format, elements);
        }
        default -> {}
      }
    }
  }

  private static String format(String[] words, Path file) throws VolumeFormatException {
    String format = words.length > 1 ? words[1] : "";
    if (!List.of("ascii", "binary_little_endian", "binary_big_endian").contains(format)) {
      throw refusal("the format is '" + format + "'", file);
    }
    return format;
  }

  private static Element element(String[] words, String line, Path file)
      throws VolumeFormatException {
    boolean isWhole = words.length == 3 && words[2].matches("\\d{1,10}");
    if (!isWhole || Long.parseLong(words[2]) > Integer.MAX_VALUE) {
      throw badLine(line, file);
    }
    return new Element(words[1], Long.parseLong(words[2]), new ArrayList<>());
  }

  private static void addProperty(String[] words, String line, List<Element> elements, Path file)
      throws VolumeFormatException {
    boolean isList = words.length == 5 && words[1].equals("list");
    if (elements.isEmpty() || !(isList || words.length == 3)) {
      throw badLine(line, file);
    }
    NumberType count = isList ? type(words[2], file) : null;
    NumberType type = type(words[isList ? 3 : 1], file);
    elements
        .get(elements.size() - 1)
        .properties()
        .add(new Property(words[words.length - 1], type, count));
  }

  private static NumberType type(String name, Path file) throws VolumeFormatException {
    return switch (name.toLowerCase(Locale.ROOT)) {
      case "char", "int8" -> NumberType.INT8;
      case "uchar", "uint8" -> NumberType.UINT8;
      case "short", "int16" -> NumberType.INT16;
      case "ushort", "uint16" -> NumberType.UINT16;
      case "int", "int32" -> NumberType.INT32;
      case "uint", "uint32" -> NumberType.UINT32;
      case "float", "float32" -> NumberType.FLOAT32;
      case "double", "float64" -> NumberType.FLOAT64;
      default -> throw refusal("its header has the type '" + name + "'", file);
    };
  }

  private static VolumeFormatException badLine(String line, Path file) {
    return refusal("its header has the line '" + line + "'", file);
  }

  static VolumeFormatException refusal(String what, Path file) {
    return new VolumeFormatException(what, file, "export the mesh again as PLY, or as STL");
  }
}
