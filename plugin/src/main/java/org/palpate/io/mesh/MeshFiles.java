package org.palpate.io.mesh;

import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.TriangleMesh;

/** Recognizes the format of a mesh file by its ending, and reads it. */
public final class MeshFiles {
  /** Memory for each byte of a file: a short line of text may become a vertex and its edges. */
  private static final double BYTES_PER_BYTE = 20;

  private MeshFiles() {}

  /**
   * Whether the name of a file ends as those of meshes do: {@code .stl}, {@code .obj}, {@code
   * .ply}.
   */
  public static boolean accepts(Path file) {
    return InputFiles.hasEnding(file, ".stl", ".obj", ".ply");
  }

  /**
   * Reads a mesh, mm.
   *
   * @throws VolumeFormatException if the file cannot be read, is damaged, or holds no triangle
   */
  public static TriangleMesh read(Path file) throws VolumeFormatException {
    long length = InputFiles.length(file);
    if (length == 0) {
      throw new VolumeFormatException("the file is empty", file, "copy or export it again");
    }
    MemoryCheck.require(BYTES_PER_BYTE * length, "the mesh", file.toString());
    MeshBuilder mesh = new MeshBuilder(file);
    try {
      if (InputFiles.hasEnding(file, ".stl")) {
        new StlReader(file, mesh).read(length);
      } else if (InputFiles.hasEnding(file, ".obj")) {
        new ObjReader(file, mesh).read();
      } else {
        new PlyReader(file, mesh).read(length);
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (EOFException e) {
      throw tooShort(file, e);
    } catch (IOException e) {
      throw InputFiles.unreadableFile(file, e);
    }
    return mesh.build();
  }

  /** Returns the exception for a file that ends too early. */
  static VolumeFormatException tooShort(Path file, Exception cause) {
    return new VolumeFormatException(
        "the file ends within the mesh",
        file,
        "copy the file again; if that does not help, export it again",
        cause);
  }
}
