package org.palpate.scene.surface;

import java.util.Arrays;

/**
 * The vertices of a padded brick: one for each sheet of each cell, with its position relative to
 * the cell's middle and its neighbours. Scratch memory of one {@link SurfaceExtractor}.
 *
 * <p>A vertex in the padding is smoothed only as long as it affects the brick: each pass reaches
 * one cell less far into the padding than the pass before.
 *
 * <p>Positions are relative and sums run in a fixed order, so a vertex gets the same bits in every
 * brick.
 */
final class SheetVertices {
  // Keeps vertices of neighbouring cells apart, and so the two sides of a thin wall.
  private static final float MAX_OFFSET = 0.49f;

  /**
   * A neighbour is stored as the index of its first coordinate in an array of vectors, and the face
   * between.
   */
  private static final int FACE_BITS = 3;

  private static final int FACE_MASK = (1 << FACE_BITS) - 1;

  /** Step from a cell to the one beyond a face, by face. */
  private static final float[] STEP_X = {-1, 1, 0, 0, 0, 0, 0, 0};

  private static final float[] STEP_Y = {0, 0, -1, 1, 0, 0, 0, 0};
  private static final float[] STEP_Z = {0, 0, 0, 0, -1, 1, 0, 0};

  /** Depth in the padding of vertices that the brick's triangles use. */
  private static final int USED_DEPTH = 1;

  /** Depth of vertices whose normals are added to the normals of used ones. */
  private static final int NORMALS_DEPTH = USED_DEPTH + 1;

  /** Depth of vertices whose positions determine the normals up to {@link #NORMALS_DEPTH}. */
  static final int POSITIONS_DEPTH = NORMALS_DEPTH + 1;

  int count;
  int[] cell = new int[1 << 12];
  byte[] sheet = new byte[1 << 12];
  private byte[] depth = new byte[1 << 12];
  float[] offset = new float[3 << 12];

  /** Smoother positions, from which normals are computed. */
  float[] forNormals = offset;

  private float[] moved = new float[3 << 12];
  private int[] neighbourStart = new int[(1 << 12) + 1];
  private int[] neighbour = new int[1 << 14];
  private int neighbourCount;

  /** Removes all vertices. */
  void clear() {
    count = 0;
  }

  /**
   * Adds a vertex and returns its number. The caller sets its offset.
   *
   * @param newDepth distance from the brick in cells, 0 inside
   */
  int add(int newCell, int newSheet, int newDepth) {
    if (count == cell.length) {
      grow();
    }
    cell[count] = newCell;
    sheet[count] = (byte) newSheet;
    depth[count] = (byte) newDepth;
    return count++;
  }

  private void grow() {
    int capacity = 2 * count;
    cell = Arrays.copyOf(cell, capacity);
    sheet = Arrays.copyOf(sheet, capacity);
    depth = Arrays.copyOf(depth, capacity);
    offset = Arrays.copyOf(offset, 3 * capacity);
    moved = new float[3 * capacity];
    neighbourStart = Arrays.copyOf(neighbourStart, capacity + 1);
  }

  /** Sets the position of a vertex relative to its cell's middle. */
  void setOffset(int vertex, float x, float y, float z) {
    offset[3 * vertex] = x;
    offset[3 * vertex + 1] = y;
    offset[3 * vertex + 2] = z;
  }

  /** Finds the neighbours of each vertex, except those beyond the padding. */
  void link(CellGrid cells) {
    neighbourCount = 0;
    for (int vertex = 0; vertex < count; vertex++) {
      neighbourStart[vertex] = neighbourCount;
      linkOne(vertex, cells);
    }
    neighbourStart[count] = neighbourCount;
  }

  private void linkOne(int vertex, CellGrid cells) {
    int at = cell[vertex];
    byte[] rim = CellCaseTable.neighbours(cells.corners[at] & 255, sheet[vertex]);
    if (neighbourCount + rim.length > neighbour.length) {
      neighbour = Arrays.copyOf(neighbour, 2 * neighbour.length);
    }
    for (byte piece : rim) {
      int face = piece >> 4;
      int beyond = cells.beyond(at, face);
      if (beyond >= 0) {
        int other = 3 * cells.vertexAt(beyond, piece & 15);
        neighbour[neighbourCount++] = (other << FACE_BITS) | face;
      }
    }
  }

  /**
   * Smooths by averaging neighbours {@code passes} times, then takes back what the same smoothing
   * leaves of the displacement, so that round shapes do not shrink. Every vertex stays in its cell.
   * {@link #forNormals} continues to smooth instead.
   *
   * <p>With S for one pass, the positions become 2 S^n - S^2n of the original ones, and those for
   * normals S^2n. Source: twicing, Tukey 1977; for meshes see Vollmer, Mencl, Mueller, Improved
   * Laplacian smoothing of noisy surface meshes (1999).
   */
  void smooth(int passes) {
    float[] before = Arrays.copyOf(offset, 3 * count);
    for (int left = 2 * passes - 1; left >= passes; left--) {
      relax(POSITIONS_DEPTH + left);
    }
    float[] smooth = Arrays.copyOf(offset, 3 * count);
    float[] displaced = new float[3 * count];
    for (int i = 0; i < displaced.length; i++) {
      displaced[i] = smooth[i] - before[i];
    }
    for (int left = passes - 1; left >= 0; left--) {
      relax(POSITIONS_DEPTH + left);
      means(displaced, before, USED_DEPTH + left);
      float[] old = displaced;
      displaced = before;
      before = old;
    }
    System.arraycopy(offset, 0, moved, 0, 3 * count);
    for (int i = 0; i < displaced.length; i++) {
      offset[i] = clamp(smooth[i] - displaced[i]);
    }
    forNormals = moved;
    moved = new float[offset.length];
  }

  /**
   * Writes the mean of each vertex's neighbours into {@code dest}, up to a depth in the padding.
   */
  private void means(float[] vectors, float[] dest, int maxDepth) {
    for (int vertex = 0; vertex < count; vertex++) {
      if (depth[vertex] <= maxDepth) {
        meanOne(vertex, vectors, dest);
      }
    }
  }

  private void meanOne(int vertex, float[] vectors, float[] dest) {
    float x = 0;
    float y = 0;
    float z = 0;
    int from = neighbourStart[vertex];
    int to = neighbourStart[vertex + 1];
    for (int i = from; i < to; i++) {
      int other = neighbour[i] >> FACE_BITS;
      x += vectors[other];
      y += vectors[other + 1];
      z += vectors[other + 2];
    }
    float factor = 1f / Math.max(1, to - from);
    dest[3 * vertex] = x * factor;
    dest[3 * vertex + 1] = y * factor;
    dest[3 * vertex + 2] = z * factor;
  }

  /**
   * Moves every vertex to the mean of its neighbours within its cell, up to a depth in the padding.
   */
  private void relax(int maxDepth) {
    for (int vertex = 0; vertex < count; vertex++) {
      if (depth[vertex] <= maxDepth) {
        relaxOne(vertex);
      }
    }
    float[] old = offset;
    offset = moved;
    moved = old;
  }

  private void relaxOne(int vertex) {
    float x = 0;
    float y = 0;
    float z = 0;
    int from = neighbourStart[vertex];
    int to = neighbourStart[vertex + 1];
    for (int i = from; i < to; i++) {
      int other = neighbour[i] >> FACE_BITS;
      int face = neighbour[i] & FACE_MASK;
      x += offset[other] + STEP_X[face];
      y += offset[other + 1] + STEP_Y[face];
      z += offset[other + 2] + STEP_Z[face];
    }
    float factor = 1f / Math.max(1, to - from);
    moved[3 * vertex] = clamp(x * factor);
    moved[3 * vertex + 1] = clamp(y * factor);
    moved[3 * vertex + 2] = clamp(z * factor);
  }

  private static float clamp(float value) {
    return Math.max(-MAX_OFFSET, Math.min(MAX_OFFSET, value));
  }

  /**
   * Adds the normals of the neighbours to the normal of each vertex that the brick uses; all are
   * unit vectors.
   */
  void smoothNormals(float[] normals, float[] dest) {
    for (int vertex = 0; vertex < count; vertex++) {
      if (depth[vertex] <= NORMALS_DEPTH) {
        normalize(normals, 3 * vertex);
      }
    }
    for (int vertex = 0; vertex < count; vertex++) {
      if (depth[vertex] <= USED_DEPTH) {
        smoothNormal(vertex, normals, dest);
      }
    }
  }

  private void smoothNormal(int vertex, float[] normals, float[] dest) {
    int at = 3 * vertex;
    float x = normals[at];
    float y = normals[at + 1];
    float z = normals[at + 2];
    for (int i = neighbourStart[vertex]; i < neighbourStart[vertex + 1]; i++) {
      int other = neighbour[i] >> FACE_BITS;
      x += normals[other];
      y += normals[other + 1];
      z += normals[other + 2];
    }
    dest[at] = x;
    dest[at + 1] = y;
    dest[at + 2] = z;
    normalize(dest, at);
  }

  private static void normalize(float[] vectors, int at) {
    float x = vectors[at];
    float y = vectors[at + 1];
    float z = vectors[at + 2];
    float length = (float) Math.sqrt(x * x + y * y + z * z);
    float factor = length > 0 ? 1 / length : 0;
    vectors[at] = x * factor;
    vectors[at + 1] = y * factor;
    vectors[at + 2] = z * factor;
  }
}
