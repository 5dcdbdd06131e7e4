package org.palpate.io.mesh;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Reads STL, binary or as text. A file is binary if its length is that of the triangles that its
 * header promises; some binary files begin with the word {@code solid} too. One thread.
 */
final class StlReader {
  private static final int HEADER_BYTES = 84;
  private static final int TRIANGLE_BYTES = 50;

  private final Path file;
  private final MeshBuilder mesh;

  StlReader(Path file, MeshBuilder mesh) {
    this.file = file;
    this.mesh = mesh;
  }

  /**
   * Reads the file.
   *
   * @param length its length, bytes
   */
  void read(long length) throws IOException {
    byte[] start = InputFiles.firstBytes(file, HEADER_BYTES);
    long promised = start.length < HEADER_BYTES ? -1 : promisedBytes(start);
    if (promised != length && isText(start)) {
      readText();
    } else if (start.length < HEADER_BYTES) {
      throw MeshFiles.tooShort(file, null);
    } else if (promised > length) {
      throw InputFiles.truncatedFile(file, (double) promised, (double) length, "");
    } else {
      readBinary((promised - HEADER_BYTES) / TRIANGLE_BYTES);
    }
  }

  private static long promisedBytes(byte[] start) {
    long count = ByteBuffer.wrap(start).order(ByteOrder.LITTLE_ENDIAN).getInt(80) & 0xffffffffL;
    return HEADER_BYTES + TRIANGLE_BYTES * count;
  }

  private static boolean isText(byte[] start) {
    return start.length >= 5
        && new String(start, 0, 5, StandardCharsets.ISO_8859_1)
            .toLowerCase(Locale.ROOT)
            .equals("solid");
  }

  private void readBinary(long count) throws IOException {
    byte[] record = new byte[TRIANGLE_BYTES];
    ByteBuffer values = ByteBuffer.wrap(record).order(ByteOrder.LITTLE_ENDIAN);
    try (DataInputStream in = new DataInputStream(InputFiles.open(file, HEADER_BYTES))) {
      for (long n = 0; n < count; n++) {
        in.readFully(record);
        for (int corner = 0; corner < 3; corner++) {
          int at = 12 + 12 * corner; // after the normal
          mesh.addVertex(values.getFloat(at), values.getFloat(at + 4), values.getFloat(at + 8));
        }
        addLastTriangle();
      }
    }
  }

  private void addLastTriangle() throws VolumeFormatException {
    int last = mesh.vertexCount();
    mesh.addTriangle(last - 3, last - 2, last - 1);
  }

  private void readText() throws IOException {
    try (InputStream in = InputFiles.open(file, 0)) {
      WordReader words = new WordReader(in, file);
      words.nextLine(); // the name of the solid
      boolean isEnded = false;
      int corners = 0;
      for (String word = words.wordOrNull(); word != null; word = words.wordOrNull()) {
        switch (word.toLowerCase(Locale.ROOT)) {
          case "vertex" -> {
            mesh.addVertex(words.number(), words.number(), words.number());
            corners++;
          }
          case "endfacet" -> {
            requireTriangle(corners, words);
            corners = 0;
            addLastTriangle();
          }
          case "endsolid", "solid" -> {
            isEnded = word.equalsIgnoreCase("endsolid");
            words.nextLine();
          }
          default -> {}
        }
      }
      if (!isEnded) {
        throw MeshFiles.tooShort(file, null);
      }
    }
  }

  private static void requireTriangle(int corners, WordReader words) throws VolumeFormatException {
    if (corners != 3) {
      throw words.refusal("the facet has " + NumberText.count(corners) + " corners instead of 3");
    }
  }
}
