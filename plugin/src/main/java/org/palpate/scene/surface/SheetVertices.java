package org.palpate.scene.surface;

import java.util.Arrays;

/**
 * One vertex for each sheet of each cell of a padded brick, its place relative to its cell's
 * middle, and its neighbours. Scratch of one {@link SurfaceExtractor}.
 *
 * <p>Places are relative and sums run in a fixed order, so a vertex gets the same bits whatever
 * brick it is computed in.
 */
final class SheetVertices {
  // Keeps vertices of neighbouring cells, and so the two sides of a thin wall, apart.
  private static final float MAX_OFFSET = 0.49f;
  private static final int FACES = 6;

  int count;
  int[] cell = new int[1 << 12];
  byte[] sheet = new byte[1 << 12];
  float[] offset = new float[3 << 12];

  /** Smoother places, to take normals from. */
  float[] forNormals = offset;

  private float[] moved = new float[3 << 12];
  private int[] neighbourStart = new int[(1 << 12) + 1];
  private int[] neighbour = new int[1 << 14];
  private int neighbourCount;

  void clear() {
    count = 0;
  }

  /** Adds a vertex and returns its number; its offset is the caller's to set. */
  int add(int newCell, int newSheet) {
    if (count == cell.length) {
      grow();
    }
    cell[count] = newCell;
    sheet[count] = (byte) newSheet;
    return count++;
  }

  private void grow() {
    int capacity = 2 * count;
    cell = Arrays.copyOf(cell, capacity);
    sheet = Arrays.copyOf(sheet, capacity);
    offset = Arrays.copyOf(offset, 3 * capacity);
    moved = new float[3 * capacity];
    neighbourStart = Arrays.copyOf(neighbourStart, capacity + 1);
  }

  void setOffset(int vertex, float x, float y, float z) {
    offset[3 * vertex] = x;
    offset[3 * vertex + 1] = y;
    offset[3 * vertex + 2] = z;
  }

  /** Finds each vertex's neighbours; those beyond the padding are left out. */
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
    byte[] ways = SheetTable.neighbours(cells.corners[at] & 255, sheet[vertex]);
    if (neighbourCount + ways.length > neighbour.length) {
      neighbour = Arrays.copyOf(neighbour, 2 * neighbour.length);
    }
    for (byte way : ways) {
      int face = way >> 4;
      int beyond = cells.beyond(at, face);
      if (beyond >= 0) {
        neighbour[neighbourCount++] = cells.vertexAt(beyond, way & 15) * FACES + face;
      }
    }
  }

  /**
   * Smooths by means of neighbours, {@code passes} times, then takes back what the same smoothing
   * leaves of the displacement, so that round things do not shrink; every vertex stays in its cell.
   * {@link #forNormals} goes on smoothing instead.
   *
   * <p>With S for one pass the places become 2 S^n - S^2n of what they were, and those for normals
   * S^2n. Source: twicing, Tukey 1977; the like for meshes in Vollmer, Mencl, Mueller, Improved
   * Laplacian smoothing of noisy surface meshes (1999).
   */
  void smooth(int passes) {
    float[] before = Arrays.copyOf(offset, 3 * count);
    for (int pass = 0; pass < passes; pass++) {
      relax();
    }
    float[] smooth = Arrays.copyOf(offset, 3 * count);
    float[] displaced = new float[3 * count];
    for (int i = 0; i < displaced.length; i++) {
      displaced[i] = smooth[i] - before[i];
    }
    for (int pass = 0; pass < passes; pass++) {
      relax();
      means(displaced, before);
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

  /** Writes the mean of each vertex's neighbours into {@code dest}. */
  private void means(float[] vectors, float[] dest) {
    Arrays.fill(dest, 0);
    for (int vertex = 0; vertex < count; vertex++) {
      int from = neighbourStart[vertex];
      int to = neighbourStart[vertex + 1];
      float share = 1f / Math.max(1, to - from);
      for (int i = from; i < to; i++) {
        int other = 3 * (neighbour[i] / FACES);
        dest[3 * vertex] += vectors[other];
        dest[3 * vertex + 1] += vectors[other + 1];
        dest[3 * vertex + 2] += vectors[other + 2];
      }
      dest[3 * vertex] *= share;
      dest[3 * vertex + 1] *= share;
      dest[3 * vertex + 2] *= share;
    }
  }

  /** Moves every vertex to the mean of its neighbours, within its cell. */
  private void relax() {
    for (int vertex = 0; vertex < count; vertex++) {
      relaxOne(vertex);
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
      int other = neighbour[i] / FACES;
      int face = neighbour[i] - other * FACES;
      int step = (face & 1) * 2 - 1;
      x += offset[3 * other] + (face >> 1 == 0 ? step : 0);
      y += offset[3 * other + 1] + (face >> 1 == 1 ? step : 0);
      z += offset[3 * other + 2] + (face >> 1 == 2 ? step : 0);
    }
    float share = 1f / Math.max(1, to - from);
    moved[3 * vertex] = clamp(x * share);
    moved[3 * vertex + 1] = clamp(y * share);
    moved[3 * vertex + 2] = clamp(z * share);
  }

  private static float clamp(float value) {
    return Math.max(-MAX_OFFSET, Math.min(MAX_OFFSET, value));
  }

  /** Adds to each vertex's normal those of its neighbours; all are made unit vectors first. */
  void smoothNormals(float[] normals, float[] dest) {
    for (int vertex = 0; vertex < count; vertex++) {
      normalize(normals, 3 * vertex);
    }
    System.arraycopy(normals, 0, dest, 0, 3 * count);
    for (int vertex = 0; vertex < count; vertex++) {
      for (int i = neighbourStart[vertex]; i < neighbourStart[vertex + 1]; i++) {
        int other = neighbour[i] / FACES;
        dest[3 * vertex] += normals[3 * other];
        dest[3 * vertex + 1] += normals[3 * other + 1];
        dest[3 * vertex + 2] += normals[3 * other + 2];
      }
      normalize(dest, 3 * vertex);
    }
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
