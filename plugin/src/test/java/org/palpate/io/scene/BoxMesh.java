package org.palpate.io.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Writes a box from the origin to (4, 3, 5) as a mesh. */
final class BoxMesh {
  private BoxMesh() {}

  /**
   * Writes the box, and returns the file.
   *
   * @param comment the first line, which may name the axes
   * @param isOpen whether the last face is left out
   */
  static Path write(Path file, String comment, boolean isOpen) throws IOException {
    StringBuilder text = new StringBuilder("# " + comment + "\n");
    for (int n = 0; n < 8; n++) {
      text.append("v ").append((n & 1) * 4).append(' ').append((n >> 1 & 1) * 3);
      text.append(' ').append((n >> 2) * 5).append('\n');
    }
    String faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\n";
    return Files.writeString(file, text + faces + (isOpen ? "" : "f 2 4 8 6\n"));
  }
}
