package org.palpate.scene.surface;

/**
 * Extracts the triangles of one brick at a time: dual surface nets with a vertex for each sheet of
 * each cell and a quad for each pair of neighbouring voxels of which one is solid.
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
  public static int reach(int smoothing) {
    return 2 * smoothing + CELLS_FOR_NORMALS + 1;
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
    BrickLayout layout = layout(from);
    source = from;
    pad = 2 * from.smoothing() + CELLS_FOR_NORMALS;
    lowX = layout.x(brick) * brickEdge - pad;
    lowY = layout.y(brick) * brickEdge - pad;
    lowZ = layout.z(brick) * brickEdge - pad;
    cells.edge = brickEdge + 2 * pad;
    rows.load(from.bits(), lowX - 1, lowY - 1, lowZ - 1, cells.edge + 1);
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

  private boolean isCoreMixed() {
    long core = ((1L << brickEdge) - 1) << pad;
    for (int z = pad; z < pad + brickEdge; z++) {
      for (int y = pad; y < pad + brickEdge; y++) {
        if ((rows.mixedCells(y, z) & core) != 0) {
          return true;
        }
      }
    }
    return false;
  }

  private void findVertices() {
    vertices.clear();
    long all = -1L >>> (Long.SIZE - cells.edge);
    for (int z = 0; z < cells.edge; z++) {
      for (int y = 0; y < cells.edge; y++) {
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
    int depth = Math.max(depth(x), Math.max(depth(y), depth(z)));
    for (int sheet = 0; sheet < CellCaseTable.count(corners); sheet++) {
      int vertex = vertices.add(cell, sheet, depth);
      meanCrossing(x, y, z, corners, sheet);
      vertices.setOffset(vertex, crossing[0], crossing[1], crossing[2]);
    }
  }

  /** Returns the distance of a cell outside the brick along one axis; 0 inside. */
  private int depth(int position) {
    return Math.max(0, Math.max(pad - position, position - (pad + brickEdge - 1)));
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
    int to = pad + brickEdge + CELLS_FOR_QUADS;
    long wanted = (-1L >>> (Long.SIZE - (to - from))) << from;
    for (int z = from; z < to; z++) {
      for (int y = from; y < to; y++) {
        boolean core = isCore(y) && isCore(z);
        for (long mixed = rows.mixedCells(y, z) & wanted; mixed != 0; mixed &= mixed - 1) {
          int x = Long.numberOfTrailingZeros(mixed);
          addQuads(cells.index(x, y, z), core && isCore(x));
        }
      }
    }
  }

  private boolean isCore(int position) {
    return depth(position) == 0;
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
