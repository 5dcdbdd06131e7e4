package org.palpate.io.mesh;

import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.geometry.Vec3;
import org.palpate.io.format.InputFiles;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.TriangleMesh;

/** Recognizes the format of a mesh file by its ending, and reads it. */
public final class MeshFiles {
  /** Memory for each byte of a file: a short line of text may become a vertex and its edges. */
  private static final double BYTES_PER_BYTE = 20;

  /** Comments with the name of the axes stand in the first bytes of a file. */
  private static final int COMMENT_BYTES = 2048;

  private static final int STL_COMMENT_BYTES = 80;

  private static final Pattern SPACE = Pattern.compile("SPACE=(LPS|RAS)\\b");

  private MeshFiles() {}

  /**
   * Whether the name of a file ends as those of meshes do: {@code .stl}, {@code .obj}, {@code
   * .ply}.
   */
  public static boolean accepts(Path file) {
    return InputFiles.hasEnding(file, ".stl", ".obj", ".ply");
  }

  /**
   * Returns the world axes that a comment at the start of a file names, as 3D Slicer writes them:
   * {@code SPACE=LPS} or {@code SPACE=RAS}. Without one they are unknown.
   *
   * @throws VolumeFormatException if the file cannot be read
   */
  public static CoordinateSystem axes(Path file) throws VolumeFormatException {
    boolean isStl = InputFiles.hasEnding(file, ".stl");
    byte[] start = InputFiles.firstBytes(file, isStl ? STL_COMMENT_BYTES : COMMENT_BYTES);
    Matcher named = SPACE.matcher(new String(start, StandardCharsets.ISO_8859_1));
    return named.find() ? CoordinateSystem.valueOf(named.group(1)) : CoordinateSystem.UNKNOWN;
  }

  /**
   * Reads a mesh and turns its axes into those of a world, mm. Axes that the file does not name are
   * taken as those of the world.
   *
   * @throws VolumeFormatException if the file cannot be read, is damaged, or holds no triangle
   */
  public static TriangleMesh read(Path file, CoordinateSystem world) throws VolumeFormatException {
    TriangleMesh mesh = read(file);
    CoordinateSystem own = axes(file);
    return own == world
        ? mesh
        : AxisSigns.between(own, world).map(signs -> turned(mesh, signs)).orElse(mesh);
  }

  private static TriangleMesh turned(TriangleMesh mesh, Vec3 signs) {
    double[] coordinates = mesh.coordinates();
    for (int n = 0; n < coordinates.length; n++) {
      coordinates[n] *= signs.get(n % 3);
    }
    return new TriangleMesh(coordinates, mesh.corners());
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
