package org.palpate.scene.surface;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/** Converts quads between smoothed vertices to the arrays of a {@link SurfaceBrick}. */
final class BrickAssembly {
  private static final int UNUSED = -1;

  private final SurfaceSource source;
  private final CellGrid cells;
  private final SheetVertices vertices;
  private final QuadList quads;
  private final float[] edgeMm;
  private final int[] numberOfVertex;
  private int used;

  BrickAssembly(SurfaceSource source, CellGrid cells, SheetVertices vertices, QuadList quads) {
    this.source = source;
    this.cells = cells;
    this.vertices = vertices;
    this.quads = quads;
    Vec3 spacing = source.spacingMm();
    edgeMm = new float[] {(float) spacing.x, (float) spacing.y, (float) spacing.z};
    numberOfVertex = new int[vertices.count];
  }

  /**
   * Returns the brick, or null if it has no triangles.
   *
   * @param low first cell of the padded brick
   * @param occlusion ambient occlusion at each vertex
   */
  SurfaceBrick assemble(int[] low, AmbientOcclusion occlusion) {
    int[] triangles = triangles();
    if (triangles.length == 0) {
      return null;
    }
    float[] summed = summedNormals();
    float[] smooth = new float[3 * vertices.count];
    vertices.smoothNormals(summed, smooth);
    SurfaceBrick brick =
        new SurfaceBrick(new float[3 * used], new short[4 * used], triangles, new long[used]);
    for (int vertex = 0; vertex < vertices.count; vertex++) {
      if (numberOfVertex[vertex] != UNUSED) {
        write(vertex, numberOfVertex[vertex], low, smooth, occlusion, brick);
      }
    }
    return brick;
  }

  private int[] triangles() {
    Arrays.fill(numberOfVertex, UNUSED);
    int[] triangles = new int[6 * quads.count];
    int at = 0;
    for (int quad = 0; quad < quads.count; quad++) {
      if (quads.isCore(quad)) {
        split(quad, triangles, at);
        at += 6;
      }
    }
    return at == triangles.length ? triangles : Arrays.copyOf(triangles, at);
  }

  /** Splits a quad along its shorter diagonal into two triangles. */
  private void split(int quad, int[] triangles, int at) {
    boolean firstDiagonal = diagonalSquared(quad, 0) <= diagonalSquared(quad, 1);
    int start = firstDiagonal ? 0 : 1;
    int turn = quads.isOutward(quad) ? 1 : 3;
    int a = numberFor(quad, start);
    int b = numberFor(quad, start + turn);
    int c = numberFor(quad, start + 2);
    int d = numberFor(quad, start + 2 + turn);
    triangles[at] = a;
    triangles[at + 1] = b;
    triangles[at + 2] = c;
    triangles[at + 3] = a;
    triangles[at + 4] = c;
    triangles[at + 5] = d;
  }

  private int numberFor(int quad, int corner) {
    int vertex = quads.corner[4 * quad + (corner & 3)];
    if (numberOfVertex[vertex] == UNUSED) {
      numberOfVertex[vertex] = used++;
    }
    return numberOfVertex[vertex];
  }

  private float diagonalSquared(int quad, int diagonal) {
    float sum = 0;
    for (int axis = 0; axis < 3; axis++) {
      float along = alongDiagonalMm(vertices.offset, quad, diagonal, axis);
      sum += along * along;
    }
    return sum;
  }

  /**
   * Returns one component of the vector from corner {@code diagonal} to the opposite one. Every
   * brick computes the same bits.
   */
  private float alongDiagonalMm(float[] offset, int quad, int diagonal, int axis) {
    int from = quads.corner[4 * quad + diagonal];
    int to = quads.corner[4 * quad + diagonal + 2];
    int u = (quads.axis(quad) + 1) % 3;
    int v = (quads.axis(quad) + 2) % 3;
    // Corners 0 to 3 are at (0,0), (-1,0), (-1,-1), (0,-1) along u and v, in cells.
    int step = axis == u ? (diagonal == 0 ? -1 : 1) : axis == v ? -1 : 0;
    return (offset[3 * to + axis] - offset[3 * from + axis] + step) * edgeMm[axis];
  }

  private float[] summedNormals() {
    float[] normals = new float[3 * vertices.count];
    float[] p = new float[3];
    float[] q = new float[3];
    for (int quad = 0; quad < quads.count; quad++) {
      for (int axis = 0; axis < 3; axis++) {
        p[axis] = alongDiagonalMm(vertices.forNormals, quad, 0, axis);
        q[axis] = alongDiagonalMm(vertices.forNormals, quad, 1, axis);
      }
      float sign = quads.isOutward(quad) ? 1 : -1;
      float x = sign * (p[1] * q[2] - p[2] * q[1]);
      float y = sign * (p[2] * q[0] - p[0] * q[2]);
      float z = sign * (p[0] * q[1] - p[1] * q[0]);
      for (int corner = 0; corner < 4; corner++) {
        int vertex = 3 * quads.corner[4 * quad + corner];
        normals[vertex] += x;
        normals[vertex + 1] += y;
        normals[vertex + 2] += z;
      }
    }
    return normals;
  }

  private void write(
      int vertex,
      int to,
      int[] low,
      float[] normals,
      AmbientOcclusion occlusion,
      SurfaceBrick brick) {
    int cell = vertices.cell[vertex];
    int cellX = low[0] + cells.x(cell);
    int cellY = low[1] + cells.y(cell);
    int cellZ = low[2] + cells.z(cell);
    float x = cellX + vertices.offset[3 * vertex];
    float y = cellY + vertices.offset[3 * vertex + 1];
    float z = cellZ + vertices.offset[3 * vertex + 2];
    brick.positionsMm()[3 * to] = x * edgeMm[0];
    brick.positionsMm()[3 * to + 1] = y * edgeMm[1];
    brick.positionsMm()[3 * to + 2] = z * edgeMm[2];
    float nx = normals[3 * vertex];
    float ny = normals[3 * vertex + 1];
    float nz = normals[3 * vertex + 2];
    brick.normals()[4 * to] = toShort(nx);
    brick.normals()[4 * to + 1] = toShort(ny);
    brick.normals()[4 * to + 2] = toShort(nz);
    brick.normals()[4 * to + 3] = toShort(occlusion.at(x, y, z, nx, ny, nz));
    brick.cells()[to] = key(cellX, cellY, cellZ, vertices.sheet[vertex]);
  }

  private static short toShort(float value) {
    return (short) Math.round(value * SurfaceBrick.FULL_SCALE);
  }

  private long key(int x, int y, int z, int sheet) {
    long row = (long) z * (source.bits().sizeY() + 1) + y;
    return (row * (source.bits().sizeX() + 1) + x) * CellCaseTable.MAX_SHEETS + sheet;
  }
}
