package org.palpate.tool;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Locale;
import org.palpate.io.file.NumberParser;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolShape;

/** The source of a tool, as the value of {@code --tool} says. Immutable. */
public sealed interface ToolSpec {
  /** The longest radius or edge of a shape, mm. */
  double LONGEST_MM = 1e6;

  /** Returns the source as messages name it. */
  String name();

  /** A single point, which the solvers of {@code proxy} move. */
  record Point() implements ToolSpec {
    @Override
    public String name() {
      return "point";
    }
  }

  /**
   * A shape around its centre, along z.
   *
   * @param text as it was written
   */
  record Shape(String text, ToolShape shape) implements ToolSpec {
    @Override
    public String name() {
      return text;
    }
  }

  /** A mesh file: STL, OBJ or PLY. */
  record MeshFile(Path file) implements ToolSpec {
    @Override
    public String name() {
      return file.toString();
    }
  }

  /** A segment of a volume file. */
  record VolumeFile(Path file) implements ToolSpec {
    @Override
    public String name() {
      return file.toString();
    }
  }

  /**
   * Parses {@code point}, {@code sphere:R}, {@code capsule:R,L}, {@code cylinder:R,L}, {@code
   * box:A,B,C}, {@code needle:R,L} or the name of a file. Lengths are in mm.
   *
   * @throws VolumeFormatException if the text is none of these, or a length is out of range
   */
  static ToolSpec parse(String text) throws VolumeFormatException {
    String word = text.strip();
    if (word.equals("point")) {
      return new Point();
    }
    int colon = word.indexOf(':');
    String name = colon < 0 ? word : word.substring(0, colon);
    String arguments = colon < 0 ? "" : word.substring(colon + 1);
    return switch (name.toLowerCase(Locale.ROOT)) {
      case "sphere" -> {
        double[] v = lengths(text, arguments, "sphere:R", "radius");
        yield new Shape(text, RodShape.sphere(v[0]));
      }
      case "capsule" -> {
        double[] v = lengths(text, arguments, "capsule:R,L", "radius", "length");
        yield new Shape(text, RodShape.capsule(v[0], v[1]));
      }
      case "cylinder" -> {
        double[] v = lengths(text, arguments, "cylinder:R,L", "radius", "length");
        yield new Shape(text, RodShape.cylinder(v[0], v[1]));
      }
      case "needle" -> {
        double[] v = lengths(text, arguments, "needle:R,L", "radius", "length");
        yield new Shape(text, RodShape.needle(v[0], v[1]));
      }
      case "box" -> {
        double[] v =
            lengths(text, arguments, "box:A,B,C", "first edge", "second edge", "third edge");
        yield new Shape(text, new BoxShape(v[0], v[1], v[2]));
      }
      default -> file(word);
    };
  }

  private static double[] lengths(String text, String arguments, String form, String... names)
      throws VolumeFormatException {
    String[] words = arguments.split(",", -1);
    if (words.length != names.length) {
      throw new VolumeFormatException(
          "the tool needs "
              + names.length
              + (names.length == 1 ? " length" : " lengths")
              + " in mm",
          "--tool " + text,
          "write --tool " + form);
    }
    double[] lengths = new double[names.length];
    for (int n = 0; n < lengths.length; n++) {
      lengths[n] = NumberParser.number(words[n]);
      if (!(lengths[n] > 0 && lengths[n] <= LONGEST_MM)) {
        throw new VolumeFormatException(
            "the " + names[n] + " of the tool is '" + words[n].strip() + "'",
            "--tool " + text,
            "give a number of mm above 0 and up to 1000000, as in --tool " + form);
      }
    }
    return lengths;
  }

  private static ToolSpec file(String word) throws VolumeFormatException {
    try {
      if (word.isEmpty() || (word.indexOf('.') < 0 && word.indexOf('/') < 0)) {
        throw unknown(word, null);
      }
      Path file = Path.of(word);
      return MeshFiles.accepts(file) ? new MeshFile(file) : new VolumeFile(file);
    } catch (InvalidPathException e) {
      throw unknown(word, e);
    }
  }

  private static VolumeFormatException unknown(String word, Exception cause) {
    return new VolumeFormatException(
        "there is no such tool",
        "--tool " + word,
        "write point, sphere:R, capsule:R,L, cylinder:R,L, box:A,B,C, needle:R,L or a file's name",
        cause);
  }
}
