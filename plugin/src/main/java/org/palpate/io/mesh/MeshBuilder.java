package org.palpate.io.mesh;

import java.nio.file.Path;
import java.util.Arrays;
import org.palpate.io.file.NumberText;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.TriangleMesh;

/** Collects the vertices and faces of a file, and checks them. One thread. */
final class MeshBuilder {
  /** The farthest that a vertex may lie from the origin along an axis, mm. */
  private static final double FARTHEST_MM = 1e7;

  private final Path file;
  private double[] coordinates = new double[3 * 256];
  private int[] corners = new int[3 * 256];
  private int coordinateCount;
  private int cornerCount;
  private int faceCorners;
  private int firstOfFace;
  private int lastOfFace;

  MeshBuilder(Path file) {
    this.file = file;
  }

  int vertexCount() {
    return coordinateCount / 3;
  }

  /** Adds a vertex, mm. */
  void addVertex(double x, double y, double z) throws VolumeFormatException {
    if (!(Math.abs(x) <= FARTHEST_MM && Math.abs(y) <= FARTHEST_MM && Math.abs(z) <= FARTHEST_MM)) {
      throw new VolumeFormatException(
          "vertex " + vertexCount() + " lies at " + x + ", " + y + ", " + z,
          file,
          "export the mesh again, with coordinates in mm of at most 10000000");
    }
    if (coordinateCount + 3 > coordinates.length) {
      coordinates = Arrays.copyOf(coordinates, grown(coordinates.length));
    }
    coordinates[coordinateCount++] = x;
    coordinates[coordinateCount++] = y;
    coordinates[coordinateCount++] = z;
  }

  /** Adds a triangle of vertices that may still follow in the file. */
  void addTriangle(int a, int b, int c) throws VolumeFormatException {
    if (cornerCount + 3 > corners.length) {
      corners = Arrays.copyOf(corners, grown(corners.length));
    }
    corners[cornerCount++] = a;
    corners[cornerCount++] = b;
    corners[cornerCount++] = c;
  }

  /** Begins a face, whose corners follow. */
  void beginFace() {
    faceCorners = 0;
  }

  /**
   * Adds a corner to the face. From the third on, each makes a triangle with the first corner and
   * the one before.
   */
  void addCorner(int vertex) throws VolumeFormatException {
    if (faceCorners == 0) {
      firstOfFace = vertex;
    } else if (faceCorners >= 2) {
      addTriangle(firstOfFace, lastOfFace, vertex);
    }
    lastOfFace = vertex;
    faceCorners++;
  }

  private int grown(int length) throws VolumeFormatException {
    if (length > (Integer.MAX_VALUE - 16) / 2) {
      throw new VolumeFormatException(
          "the mesh has more triangles than fit in memory", file, "reduce its triangles");
    }
    return 2 * length;
  }

  /** Returns the mesh after a check of all indices. */
  TriangleMesh build() throws VolumeFormatException {
    for (int n = 0; n < cornerCount; n++) {
      if (corners[n] < 0 || corners[n] >= vertexCount()) {
        throw new VolumeFormatException(
            "face "
                + n / 3
                + " names vertex "
                + corners[n]
                + " of "
                + NumberText.count(vertexCount()),
            file,
            "export the mesh again; this file is damaged");
      }
    }
    try {
      return new TriangleMesh(
          Arrays.copyOf(coordinates, coordinateCount), Arrays.copyOf(corners, cornerCount));
    } catch (IllegalArgumentException e) {
      throw new VolumeFormatException(
          "the file holds no triangle with an area", file, "export a mesh with faces", e);
    }
  }
}
