package org.palpate.scene.surface;

import java.util.Arrays;
import java.util.function.LongPredicate;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Replaces the triangles of some cells of a brick, so that an edit costs as much as the cells that
 * it touches.
 *
 * <p>A quad belongs to that of its vertices' four cells which has the highest number. Quads stand
 * in the order of their cells, and vertices in the order in which quads use them. So the result has
 * the bits of a brick that is extracted as a whole. One thread.
 */
final class BrickPatch {
  /** The corners of the two triangles of a quad. */
  private static final int CORNERS = 6;

  private static final int UNKNOWN = -1;

  private final BitCube bits;
  private final IntBox patched;
  private final SurfaceBrick mesh;

  /**
   * Creates a patch.
   *
   * @param bits the solid voxels of the surface
   * @param patched the cells whose triangles are replaced
   * @param mesh the triangles of these cells
   */
  BrickPatch(BitCube bits, IntBox patched, SurfaceBrick mesh) {
    this.bits = bits;
    this.patched = patched;
    this.mesh = mesh;
  }

  /**
   * Returns a brick with the triangles of the patch in place of its own; null if none are left.
   *
   * @param cells the cells of the brick
   */
  SurfaceBrick appliedTo(SurfaceBrick brick, IntBox cells) {
    Quads kept = new Quads(brick, cell -> !isIn(patched, cell));
    Quads fresh = new Quads(mesh, cell -> isIn(cells, cell));
    Merger merger = new Merger(brick, mesh);
    while (kept.cell != Quads.END || fresh.cell != Quads.END) {
      Quads first = kept.cell < fresh.cell ? kept : fresh;
      merger.add(first);
      first.next();
    }
    return merger.merged();
  }

  /** Whether a box contains a cell, given by its number. */
  private boolean isIn(IntBox box, long cell) {
    long row = cell / (bits.sizeX() + 1);
    return box.contains(
        (int) (cell % (bits.sizeX() + 1)),
        (int) (row % (bits.sizeY() + 1)),
        (int) (row / (bits.sizeY() + 1)));
  }

  /** The quads of a mesh that belong to some of its cells, one after the other. */
  private static final class Quads {
    static final long END = Long.MAX_VALUE;

    final SurfaceBrick mesh;

    /** Whether the quads of a cell, given by its number, are wanted. */
    private final LongPredicate isWanted;

    /** The number of each vertex in the result. */
    final int[] numberOf;

    /** The first corner of the present quad. */
    int at = -CORNERS;

    /** The number of the cell to which the present quad belongs. */
    long cell;

    Quads(SurfaceBrick mesh, LongPredicate isWanted) {
      this.mesh = mesh;
      this.isWanted = isWanted;
      numberOf = new int[mesh.vertexCount()];
      Arrays.fill(numberOf, UNKNOWN);
      next();
    }

    void next() {
      do {
        at += CORNERS;
        cell = at < mesh.triangles().length ? cellOfQuad() : END;
      } while (cell != END && !isWanted.test(cell));
    }

    /**
     * Returns the number of the cell of a quad. Only its last corner is not in its first triangle.
     */
    private long cellOfQuad() {
      long first = Math.max(key(at), key(at + 1));
      long second = Math.max(key(at + 2), key(at + CORNERS - 1));
      return Math.max(first, second) / CellCaseTable.MAX_SHEETS;
    }

    private long key(int corner) {
      return mesh.cells()[mesh.triangles()[corner]];
    }
  }

  /** Collects quads in their order. */
  private static final class Merger {
    private final VertexNumbers numbers;
    private final float[] positionsMm;
    private final short[] normals;
    private final long[] cells;
    private final int[] triangles;
    private int corners;

    Merger(SurfaceBrick one, SurfaceBrick other) {
      int vertices = one.vertexCount() + other.vertexCount();
      numbers = new VertexNumbers(vertices);
      positionsMm = new float[3 * vertices];
      normals = new short[4 * vertices];
      cells = new long[vertices];
      triangles = new int[one.triangles().length + other.triangles().length];
    }

    void add(Quads quads) {
      for (int corner = quads.at; corner < quads.at + CORNERS; corner++) {
        triangles[corners++] = number(quads, quads.mesh.triangles()[corner]);
      }
    }

    private int number(Quads quads, int vertex) {
      if (quads.numberOf[vertex] == UNKNOWN) {
        int count = numbers.count();
        quads.numberOf[vertex] = numbers.number(quads.mesh.cells()[vertex]);
        if (quads.numberOf[vertex] == count) {
          copy(quads.mesh, vertex, count);
        }
      }
      return quads.numberOf[vertex];
    }

    private void copy(SurfaceBrick from, int vertex, int to) {
      System.arraycopy(from.positionsMm(), 3 * vertex, positionsMm, 3 * to, 3);
      System.arraycopy(from.normals(), 4 * vertex, normals, 4 * to, 4);
      cells[to] = from.cells()[vertex];
    }

    SurfaceBrick merged() {
      int vertices = numbers.count();
      return corners == 0
          ? null
          : new SurfaceBrick(
              Arrays.copyOf(positionsMm, 3 * vertices),
              Arrays.copyOf(normals, 4 * vertices),
              Arrays.copyOf(triangles, corners),
              Arrays.copyOf(cells, vertices));
    }
  }
}
