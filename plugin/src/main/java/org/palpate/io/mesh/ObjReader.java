package org.palpate.io.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import org.palpate.io.format.InputFiles;
import org.palpate.io.volume.VolumeFormatException;

/**
 * Reads the vertices and faces of a Wavefront OBJ file. Faces with more than three corners become
 * fans of triangles. Lines of other kinds are skipped. One thread.
 */
final class ObjReader {
  private final Path file;
  private final MeshBuilder mesh;

  ObjReader(Path file, MeshBuilder mesh) {
    this.file = file;
    this.mesh = mesh;
  }

  void read() throws IOException {
    try (InputStream in = InputFiles.open(file, 0)) {
      WordReader words = new WordReader(in, file);
      do {
        if (words.hasWordInLine()) {
          readLine(words);
        }
      } while (words.nextLine());
    }
  }

  private void readLine(WordReader words) throws IOException {
    switch (words.word()) {
      case "v" -> mesh.addVertex(number(words), number(words), number(words));
      case "f" -> readFace(words);
      default -> {}
    }
  }

  private static double number(WordReader words) throws IOException {
    if (!words.hasWordInLine()) {
      throw words.refusal("a vertex needs three coordinates");
    }
    return words.number();
  }

  private void readFace(WordReader words) throws IOException {
    int corners = 0;
    mesh.beginFace();
    while (words.hasWordInLine()) {
      mesh.addCorner(vertex(words));
      corners++;
    }
    if (corners < 3) {
      throw words.refusal("a face needs at least three corners");
    }
  }

  /** Returns the index of a corner such as {@code 7}, {@code 7/1/3} or {@code -2}. */
  private int vertex(WordReader words) throws IOException {
    String word = words.word();
    int slash = word.indexOf('/');
    int number = integer(slash < 0 ? word : word.substring(0, slash), words);
    int index = number > 0 ? number - 1 : mesh.vertexCount() + number;
    if (number == 0 || index < 0) {
      throw words.refusal("a face names vertex " + word);
    }
    return index;
  }

  private static int integer(String text, WordReader words) throws VolumeFormatException {
    try {
      return Integer.parseInt(text);
    } catch (NumberFormatException e) {
      throw words.refusal("'" + text + "' is no number of a vertex");
    }
  }
}
