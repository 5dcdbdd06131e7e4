package org.palpate.scene.surface;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * A table of how the surface passes through a cell whose eight corners are voxel centres. It has
 * all 256 cases, and derives them from two rules.
 *
 * <p>Rule for a face whose solid corners are opposite: the solid corners are connected and each
 * empty corner is cut off, because a point cannot pass between two closed voxels that share an
 * edge. Rule for a cell whose only solid corners are opposite corners of the cell: they touch in
 * one point, so they are connected. Hence the surface separates empty from solid as the ray cast
 * does.
 *
 * <p>Corner bits: 1 for +x, 2 for +y, 4 for +z. An edge is {@code axis * 4 + u + 2 * v}, where u
 * and v are its positions (0 or 1) along the next two axes. A face is {@code axis * 2 + side}.
 *
 * <p>Reference: Nielson, Dual marching cubes (2004), which calls a sheet a patch.
 */
final class CellCaseTable {
  static final int EDGES = 12;

  /** The most separate sheets of a cell. */
  static final int MAX_SHEETS = 4;

  private static final byte NONE = -1;

  private static final byte[] COUNT = new byte[256];
  private static final byte[] SHEET_OF_EDGE = new byte[256 * EDGES];
  private static final byte[][] NEIGHBOURS = new byte[256 * MAX_SHEETS][];

  static {
    for (int corners = 0; corners < 256; corners++) {
      derive(corners);
    }
  }

  private CellCaseTable() {}

  /** Returns the number of sheets; 0 if all corners are alike. */
  static int count(int corners) {
    return COUNT[corners];
  }

  /** Returns the sheet that crosses an edge; -1 if none does. */
  static int sheetOfEdge(int corners, int edge) {
    return SHEET_OF_EDGE[corners * EDGES + edge];
  }

  /**
   * Returns the continuations of a sheet into neighbouring cells, one for each piece of its rim.
   *
   * <p>An entry is {@code face * 16 + edge}, with the edge as the cell beyond the face numbers it.
   * The array is shared and read-only.
   */
  static byte[] neighbours(int corners, int sheet) {
    return NEIGHBOURS[corners * MAX_SHEETS + sheet];
  }

  /** Returns the corner at an edge's low end. The other end also has the bit of the edge's axis. */
  static int lowCorner(int edge) {
    int axis = edge >> 2;
    return ((edge & 1) << ((axis + 1) % 3)) | (((edge >> 1) & 1) << ((axis + 2) % 3));
  }

  private static boolean crosses(int corners, int edge) {
    int low = lowCorner(edge);
    int high = low | (1 << (edge >> 2));
    return ((corners >> low) & 1) != ((corners >> high) & 1);
  }

  private static void derive(int corners) {
    List<int[]> rims = rims(corners);
    int[] sheets = new int[EDGES];
    Arrays.setAll(sheets, edge -> edge);
    for (int[] rim : rims) {
      join(sheets, rim[1], rim[2]);
    }
    if (Integer.bitCount(corners) == 2 && (corners & mirrored(corners)) == corners) {
      joinAll(sheets, corners);
    }
    number(corners, sheets);
    for (int sheet = 0; sheet < COUNT[corners]; sheet++) {
      NEIGHBOURS[corners * MAX_SHEETS + sheet] = neighboursOf(corners, sheet, rims);
    }
  }

  /** Returns the corners opposite to those that are set. */
  private static int mirrored(int corners) {
    return Integer.reverse(corners) >>> 24;
  }

  private static void joinAll(int[] sheets, int corners) {
    int first = 0;
    while (!crosses(corners, first)) {
      first++;
    }
    for (int edge = first + 1; edge < EDGES; edge++) {
      if (crosses(corners, edge)) {
        join(sheets, first, edge);
      }
    }
  }

  private static void join(int[] sheets, int a, int b) {
    int from = sheets[a];
    int to = sheets[b];
    for (int edge = 0; edge < EDGES; edge++) {
      if (sheets[edge] == from) {
        sheets[edge] = to;
      }
    }
  }

  private static void number(int corners, int[] sheets) {
    byte[] numbers = new byte[EDGES];
    Arrays.fill(numbers, NONE);
    for (int edge = 0; edge < EDGES; edge++) {
      boolean crossed = crosses(corners, edge);
      if (crossed && numbers[sheets[edge]] == NONE) {
        numbers[sheets[edge]] = COUNT[corners]++;
      }
      SHEET_OF_EDGE[corners * EDGES + edge] = crossed ? numbers[sheets[edge]] : NONE;
    }
  }

  private static byte[] neighboursOf(int corners, int sheet, List<int[]> rims) {
    List<Byte> found = new ArrayList<>();
    for (int[] rim : rims) {
      if (sheetOfEdge(corners, rim[1]) == sheet) {
        found.add((byte) ((rim[0] << 4) | asNeighbourNumbersIt(rim[0], rim[1])));
      }
    }
    byte[] packed = new byte[found.size()];
    for (int i = 0; i < packed.length; i++) {
      packed[i] = found.get(i);
    }
    return packed;
  }

  private static int asNeighbourNumbersIt(int face, int edge) {
    boolean faceIsAlongU = (face >> 1) == ((edge >> 2) + 1) % 3;
    return edge ^ (faceIsAlongU ? 1 : 2);
  }

  /** Returns {face, edge, edge} for each line in which the surface meets a face. */
  private static List<int[]> rims(int corners) {
    List<int[]> rims = new ArrayList<>();
    for (int face = 0; face < 6; face++) {
      addRims(corners, face, rims);
    }
    return rims;
  }

  private static void addRims(int corners, int face, List<int[]> rims) {
    int[] around = cornersAround(face);
    int[] crossed = new int[4];
    int count = 0;
    for (int i = 0; i < 4; i++) {
      int edge = edgeBetween(around[i], around[(i + 1) % 4]);
      if (crosses(corners, edge)) {
        crossed[count++] = edge;
      }
    }
    if (count == 2) {
      rims.add(new int[] {face, crossed[0], crossed[1]});
    } else if (count == 4) {
      cutOffEmptyCorners(corners, face, around, rims);
    }
  }

  private static void cutOffEmptyCorners(int corners, int face, int[] around, List<int[]> rims) {
    for (int i = 0; i < 4; i++) {
      if (((corners >> around[i]) & 1) == 0) {
        int before = edgeBetween(around[(i + 3) % 4], around[i]);
        int after = edgeBetween(around[i], around[(i + 1) % 4]);
        rims.add(new int[] {face, before, after});
      }
    }
  }

  private static int[] cornersAround(int face) {
    int axis = face >> 1;
    int fixed = (face & 1) << axis;
    int u = 1 << ((axis + 1) % 3);
    int v = 1 << ((axis + 2) % 3);
    return new int[] {fixed, fixed | u, fixed | u | v, fixed | v};
  }

  private static int edgeBetween(int corner, int otherCorner) {
    int axis = Integer.numberOfTrailingZeros(corner ^ otherCorner);
    int low = corner & otherCorner;
    return axis * 4 + ((low >> ((axis + 1) % 3)) & 1) + 2 * ((low >> ((axis + 2) % 3)) & 1);
  }
}
