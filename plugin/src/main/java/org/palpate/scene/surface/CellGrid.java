package org.palpate.scene.surface;

/**
 * The cells of a padded brick: their corner bits and their first vertices. Scratch memory of one
 * {@link SurfaceExtractor}; only mixed cells have meaningful values.
 */
final class CellGrid {
  static final int MAX_EDGE = BitRows.MAX_EDGE - 1;

  final byte[] corners = new byte[MAX_EDGE * MAX_EDGE * MAX_EDGE];
  final int[] firstVertex = new int[MAX_EDGE * MAX_EDGE * MAX_EDGE];
  int sizeX;
  int sizeY;
  int sizeZ;

  /** Sets the number of cells along each axis, at most {@link #MAX_EDGE}. */
  void resize(int newSizeX, int newSizeY, int newSizeZ) {
    sizeX = newSizeX;
    sizeY = newSizeY;
    sizeZ = newSizeZ;
  }

  /** Returns the number of a cell. */
  int index(int x, int y, int z) {
    return (z * sizeY + y) * sizeX + x;
  }

  /** Returns the position of a cell along x. */
  int x(int cell) {
    return cell % sizeX;
  }

  /** Returns the position of a cell along y. */
  int y(int cell) {
    return cell / sizeX % sizeY;
  }

  /** Returns the position of a cell along z. */
  int z(int cell) {
    return cell / sizeX / sizeY;
  }

  /** Returns the cell beyond a face; -1 outside the padding. */
  int beyond(int cell, int face) {
    int position = face < 2 ? x(cell) : face < 4 ? y(cell) : z(cell);
    int size = face < 2 ? sizeX : face < 4 ? sizeY : sizeZ;
    boolean high = (face & 1) != 0;
    if (position == (high ? size - 1 : 0)) {
      return -1;
    }
    int stride = stride(face >> 1);
    return high ? cell + stride : cell - stride;
  }

  /** Returns the difference between the numbers of two cells that are neighbours along an axis. */
  int stride(int axis) {
    return axis == 0 ? 1 : axis == 1 ? sizeX : sizeX * sizeY;
  }

  /** Returns the vertex of the sheet that crosses an edge of a cell. */
  int vertexAt(int cell, int edgeOfCell) {
    return firstVertex[cell] + CellCaseTable.sheetOfEdge(corners[cell] & 255, edgeOfCell);
  }
}
