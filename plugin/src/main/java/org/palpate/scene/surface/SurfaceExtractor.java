package org.palpate.scene.surface;

import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Extracts the triangles of a brick or of a smaller box of cells: dual surface nets with a vertex
 * for each sheet of each cell and a quad for each pair of neighbouring voxels of which one is
 * solid.
 *
 * <p>The surface is always closed, and manifold wherever the solid voxels, as closed cells, are.
 * Every vertex stays in its cell, so no voxel centre changes sides. Bricks fit together bit for
 * bit.
 *
 * <p>Owns about 3 MB of scratch memory; one thread at a time.
 *
 * <p>Reference: Gibson, Constrained elastic surface nets (1998), for the smoothing within the cell;
 * Nielson, Dual marching cubes (2004), for one vertex a sheet.
 */
public final class SurfaceExtractor {
  /** Cells along an edge of a brick. */
  public static final int BRICK_EDGE = 40;

  /** The largest smoothing for which a brick of {@link #BRICK_EDGE} has padding. */
  public static final int MAX_SMOOTHING = 4;

  /**
   * Padding in cells: a brick's quads reach one cell back, their normals' neighbours one more, and
   * the quads of those one more.
   */
  private static final int CELLS_FOR_NORMALS = SheetVertices.POSITIONS_DEPTH;

  /** Padding in cells of the quads around vertices whose normals count. */
  private static final int CELLS_FOR_QUADS = CELLS_FOR_NORMALS - 1;

  private final int brickEdge;
  private final BitRows rows = new BitRows();
  private final CellGrid cells = new CellGrid();
  private final SheetVertices vertices = new SheetVertices();
  private final QuadList quads = new QuadList();
  private final float[] crossing = new float[3];
  private SurfaceSource source;
  private int pad;
  private int coreX;
  private int coreY;
  private int coreZ;
  private int lowX;
  private int lowY;
  private int lowZ;

  /** Creates an extractor for bricks of {@link #BRICK_EDGE}. */
  public SurfaceExtractor() {
    this(BRICK_EDGE);
  }

  /**
   * Creates an extractor for bricks of another size, to compare.
   *
   * @param brickEdge edge in cells, 1 to {@link #BRICK_EDGE}
   */
  SurfaceExtractor(int brickEdge) {
    if (brickEdge < 1 || brickEdge > BRICK_EDGE) {
      throw new IllegalArgumentException(
          "brickEdge must be 1 to " + BRICK_EDGE + ": brickEdge=" + brickEdge);
    }
    this.brickEdge = brickEdge;
  }

  /** Returns the distance in cells over which a voxel changes a vertex or a normal. */
  private static int reach(int smoothing) {
    return 2 * smoothing + CELLS_FOR_NORMALS + 1;
  }

  /**
   * Writes the cells whose triangles may change with the given voxels into {@code dest}. It is
   * empty if the voxels are.
   *
   * @param voxels a box around the changed voxels
   */
  static IntBox touchedCells(SurfaceSource of, IntBox voxels, IntBox dest) {
    BitCube bits = of.bits();
    int reach = reach(of.smoothing());
    dest.clear();
    if (!voxels.isEmpty()) {
      IntBox grown = new IntBox().set(voxels).grow(reach);
      includeInGrid(bits, grown.lowX, grown.lowY, grown.lowZ, dest);
      includeInGrid(bits, grown.highX + 1, grown.highY + 1, grown.highZ + 1, dest);
    }
    return dest;
  }

  /** Includes the cell of the grid that is nearest to (x,y,z). */
  private static void includeInGrid(BitCube bits, int x, int y, int z, IntBox dest) {
    dest.include(
        Math.max(0, Math.min(bits.sizeX(), x)),
        Math.max(0, Math.min(bits.sizeY(), y)),
        Math.max(0, Math.min(bits.sizeZ(), z)));
  }

  /** Returns the layout of the bricks of a source. */
  public BrickLayout layout(SurfaceSource of) {
    return BrickLayout.of(of.bits(), brickEdge);
  }

  /**
   * Returns the triangles of a brick; null if it has none.
   *
   * @param from the source of the surface
   * @param occlusion the ambient occlusion
   * @param brick a brick number of the {@link #layout}
   */
  public SurfaceBrick extract(SurfaceSource from, AmbientOcclusion occlusion, int brick) {
    return extract(from, occlusion, layout(from).cellsOf(brick, new IntBox()));
  }

  /**
   * Returns the triangles that belong to the cells of a box, with the bits that they have in a
   * brick; null if there are none.
   *
   * @param box at most {@link #BRICK_EDGE} cells along each axis
   */
  SurfaceBrick extract(SurfaceSource from, AmbientOcclusion occlusion, IntBox box) {
    begin(from, box);
    if (!isCoreMixed()) {
      return null;
    }
    findVertices();
    vertices.link(cells);
    vertices.smooth(from.smoothing());
    findQuads();
    return quads.count == 0
        ? null
        : new BrickAssembly(from, cells, vertices, quads)
            .assemble(new int[] {lowX, lowY, lowZ}, occlusion);
  }

  /** Loads the voxels around a box of cells. */
  private void begin(SurfaceSource from, IntBox box) {
    source = from;
    pad = 2 * from.smoothing() + CELLS_FOR_NORMALS;
    coreX = box.highX - box.lowX + 1;
    coreY = box.highY - box.lowY + 1;
    coreZ = box.highZ - box.lowZ + 1;
    lowX = box.lowX - pad;
    lowY = box.lowY - pad;
    lowZ = box.lowZ - pad;
    cells.resize(coreX + 2 * pad, coreY + 2 * pad, coreZ + 2 * pad);
    IntBox voxels = new IntBox();
    voxels.include(lowX - 1, lowY - 1, lowZ - 1);
    voxels.include(box.highX + pad, box.highY + pad, box.highZ + pad);
    rows.load(from.bits(), voxels);
  }

  private boolean isCoreMixed() {
    long core = ((1L << coreX) - 1) << pad;
    for (int z = pad; z < pad + coreZ; z++) {
      for (int y = pad; y < pad + coreY; y++) {
        if ((rows.mixedCells(y, z) & core) != 0) {
          return true;
        }
      }
    }
    return false;
  }

  private void findVertices() {
    vertices.clear();
    long all = -1L >>> (Long.SIZE - cells.sizeX);
    for (int z = 0; z < cells.sizeZ; z++) {
      for (int y = 0; y < cells.sizeY; y++) {
        for (long mixed = rows.mixedCells(y, z) & all; mixed != 0; mixed &= mixed - 1) {
          addVertices(Long.numberOfTrailingZeros(mixed), y, z);
        }
      }
    }
  }

  private void addVertices(int x, int y, int z) {
    int cell = cells.index(x, y, z);
    int corners = rows.corners(x, y, z);
    cells.corners[cell] = (byte) corners;
    cells.firstVertex[cell] = vertices.count;
    int depth = Math.max(depth(x, coreX), Math.max(depth(y, coreY), depth(z, coreZ)));
    for (int sheet = 0; sheet < CellCaseTable.count(corners); sheet++) {
      int vertex = vertices.add(cell, sheet, depth);
      meanCrossing(x, y, z, corners, sheet);
      vertices.setOffset(vertex, crossing[0], crossing[1], crossing[2]);
    }
  }

  /** Returns the distance of a cell outside the core along one axis; 0 inside. */
  private int depth(int position, int core) {
    return Math.max(0, Math.max(pad - position, position - (pad + core - 1)));
  }

  private void meanCrossing(int x, int y, int z, int corners, int sheet) {
    float sumX = 0;
    float sumY = 0;
    float sumZ = 0;
    int count = 0;
    for (int edge = 0; edge < CellCaseTable.EDGES; edge++) {
      if (CellCaseTable.sheetOfEdge(corners, edge) == sheet) {
        setCrossing(x, y, z, edge);
        sumX += crossing[0];
        sumY += crossing[1];
        sumZ += crossing[2];
        count++;
      }
    }
    crossing[0] = sumX / count;
    crossing[1] = sumY / count;
    crossing[2] = sumZ / count;
  }

  private void setCrossing(int x, int y, int z, int edge) {
    int axis = edge >> 2;
    int corner = CellCaseTable.lowCorner(edge);
    int stepX = corner & 1;
    int stepY = (corner >> 1) & 1;
    int stepZ = corner >> 2;
    crossing[0] = stepX - 0.5f;
    crossing[1] = stepY - 0.5f;
    crossing[2] = stepZ - 0.5f;
    crossing[axis] +=
        source
            .crossings()
            .fraction(lowX + x - 1 + stepX, lowY + y - 1 + stepY, lowZ + z - 1 + stepZ, axis);
  }

  private void findQuads() {
    quads.clear();
    int from = pad - CELLS_FOR_QUADS;
    int toY = pad + coreY + CELLS_FOR_QUADS;
    int toZ = pad + coreZ + CELLS_FOR_QUADS;
    long wanted = (-1L >>> (Long.SIZE - (coreX + 2 * CELLS_FOR_QUADS))) << from;
    for (int z = from; z < toZ; z++) {
      for (int y = from; y < toY; y++) {
        boolean core = depth(y, coreY) == 0 && depth(z, coreZ) == 0;
        for (long mixed = rows.mixedCells(y, z) & wanted; mixed != 0; mixed &= mixed - 1) {
          int x = Long.numberOfTrailingZeros(mixed);
          addQuads(cells.index(x, y, z), core && depth(x, coreX) == 0);
        }
      }
    }
  }

  private void addQuads(int cell, boolean core) {
    int corners = cells.corners[cell];
    for (int axis = 0; axis < 3; axis++) {
      boolean solid = (corners & 1) != 0;
      boolean nextSolid = ((corners >> (1 << axis)) & 1) != 0;
      if (solid != nextSolid) {
        addQuad(cell, axis, solid, core);
      }
    }
  }

  /** Adds the quad between the four cells around the edge from a cell's corner 0 along an axis. */
  private void addQuad(int cell, int axis, boolean solid, boolean core) {
    int u = cells.stride((axis + 1) % 3);
    int v = cells.stride((axis + 2) % 3);
    int edge = axis * 4;
    quads.add(
        cells.vertexAt(cell, edge),
        cells.vertexAt(cell - u, edge + 1),
        cells.vertexAt(cell - u - v, edge + 3),
        cells.vertexAt(cell - v, edge + 2),
        (axis << 2) | (solid ? QuadList.OUTWARD : 0) | (core ? QuadList.CORE : 0));
  }
}
