package org.palpate.scene.surface;

/**
 * The cells of a padded brick: their corners, and where their vertices start. Scratch of one {@link
 * SurfaceExtractor}; only mixed cells hold meaningful values.
 */
final class CellGrid {
  static final int MAX_EDGE = BitRows.MAX_EDGE - 1;

  final byte[] corners = new byte[MAX_EDGE * MAX_EDGE * MAX_EDGE];
  final int[] firstVertex = new int[MAX_EDGE * MAX_EDGE * MAX_EDGE];
  int edge;

  int index(int x, int y, int z) {
    return (z * edge + y) * edge + x;
  }

  int x(int cell) {
    return cell % edge;
  }

  int y(int cell) {
    return cell / edge % edge;
  }

  int z(int cell) {
    return cell / edge / edge;
  }

  /** The cell beyond a face; -1 where the padding ends. */
  int beyond(int cell, int face) {
    int place = face < 2 ? x(cell) : face < 4 ? y(cell) : z(cell);
    boolean high = (face & 1) != 0;
    if (place == (high ? edge - 1 : 0)) {
      return -1;
    }
    int stride = stride(face >> 1);
    return high ? cell + stride : cell - stride;
  }

  int stride(int axis) {
    return axis == 0 ? 1 : axis == 1 ? edge : edge * edge;
  }

  /** The vertex of the sheet that crosses an edge of a cell. */
  int vertexAt(int cell, int edgeOfCell) {
    return firstVertex[cell] + CellCaseTable.sheetOfEdge(corners[cell] & 255, edgeOfCell);
  }
}
