package org.palpate.io.mesh;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Path;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.InputFiles;
import org.palpate.io.mesh.PlyHeader.Element;
import org.palpate.io.mesh.PlyHeader.NumberType;
import org.palpate.io.mesh.PlyHeader.Property;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Reads the vertices and faces of a PLY file: text, or binary in both byte orders. Faces with more
 * than three corners become fans of triangles. Other elements and properties are skipped. One
 * thread.
 */
final class PlyReader {
  private final Path file;
  private final MeshBuilder mesh;

  PlyReader(Path file, MeshBuilder mesh) {
    this.file = file;
    this.mesh = mesh;
  }

  /**
   * Reads the file.
   *
   * @param length its length, bytes
   */
  void read(long length) throws IOException {
    try (InputStream in = InputFiles.open(file, 0)) {
      PlyHeader header = PlyHeader.read(in, file);
      requireLength(header, length);
      Numbers numbers = header.isText() ? new TextNumbers(in, file) : new BinaryNumbers(in, header);
      for (Element element : header.elements()) {
        readElement(element, numbers);
      }
    }
  }

  private void requireLength(PlyHeader header, long length) throws VolumeFormatException {
    long least = 0;
    for (Element element : header.elements()) {
      long each = header.isText() ? 2L * element.properties().size() - 1 : element.leastBytes();
      least += element.count() * Math.max(0, each);
    }
    if (least > length) {
      throw InputFiles.truncatedFile(file, (double) least, (double) length, "");
    }
  }

  private void readElement(Element element, Numbers numbers) throws IOException {
    if (element.properties().isEmpty()) {
      return;
    }
    boolean isVertex = element.name().equals("vertex");
    boolean isFace = element.name().equals("face");
    requireCoordinates(element, isVertex);
    double[] position = new double[3];
    for (long n = 0; n < element.count(); n++) {
      for (Property property : element.properties()) {
        if (property.isList()) {
          readList(property, numbers, isFace && property.isCorners());
        } else {
          double value = numbers.next(property.type());
          if (property.axis() >= 0) {
            position[property.axis()] = value;
          }
        }
      }
      if (isVertex) {
        mesh.addVertex(position[0], position[1], position[2]);
      }
    }
  }

  private void requireCoordinates(Element element, boolean isVertex) throws VolumeFormatException {
    long found =
        element.properties().stream()
            .filter(p -> !p.isList() && p.axis() >= 0)
            .map(Property::axis)
            .distinct()
            .count();
    if (isVertex && found < 3) {
      throw PlyHeader.refusal("its vertices have no x, y and z", file);
    }
  }

  private void readList(Property property, Numbers numbers, boolean isCorners) throws IOException {
    double count = numbers.next(property.countType());
    if (!(count >= 0 && count == Math.rint(count) && count <= Integer.MAX_VALUE)) {
      throw PlyHeader.refusal("a list has " + NumberText.display(count) + " entries", file);
    }
    mesh.beginFace();
    for (int n = 0; n < (int) count; n++) {
      double value = numbers.next(property.type());
      if (isCorners) {
        mesh.addCorner(index(value));
      }
    }
  }

  private int index(double value) throws VolumeFormatException {
    if (!(value >= 0 && value <= Integer.MAX_VALUE && value == Math.rint(value))) {
      throw PlyHeader.refusal("a face names vertex " + NumberText.display(value), file);
    }
    return (int) value;
  }

  /** Gives the numbers of the data one after the other. */
  private interface Numbers {
    double next(NumberType type) throws IOException;
  }

  /** Numbers as words. */
  private static final class TextNumbers implements Numbers {
    private final WordReader words;

    TextNumbers(InputStream in, Path file) throws IOException {
      words = new WordReader(in, file);
    }

    @Override
    public double next(NumberType type) throws IOException {
      return words.number();
    }
  }

  /** Numbers in their binary form. */
  private static final class BinaryNumbers implements Numbers {
    private final DataInputStream in;
    private final byte[] bytes = new byte[8];
    private final ByteBuffer buffer;

    BinaryNumbers(InputStream in, PlyHeader header) {
      this.in = new DataInputStream(in);
      boolean isBig = header.format().equals("binary_big_endian");
      buffer = ByteBuffer.wrap(bytes).order(isBig ? ByteOrder.BIG_ENDIAN : ByteOrder.LITTLE_ENDIAN);
    }

    @Override
    public double next(NumberType type) throws IOException {
      in.readFully(bytes, 0, type.bytes);
      return switch (type) {
        case INT8 -> buffer.get(0);
        case UINT8 -> buffer.get(0) & 0xff;
        case INT16 -> buffer.getShort(0);
        case UINT16 -> buffer.getShort(0) & 0xffff;
        case INT32 -> buffer.getInt(0);
        case UINT32 -> buffer.getInt(0) & 0xffffffffL;
        case FLOAT32 -> buffer.getFloat(0);
        case FLOAT64 -> buffer.getDouble(0);
      };
    }
  }
}
