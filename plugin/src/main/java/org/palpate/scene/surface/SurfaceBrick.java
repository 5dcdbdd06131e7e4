package org.palpate.scene.surface;

/** The triangles of one brick of cells. Immutable by convention: its arrays are read-only. */
public final class SurfaceBrick {
  /** Value that stands for 1 in a normal's component and in the ambient light. */
  public static final int FULL_SCALE = Short.MAX_VALUE;

  /** A brick without triangles. */
  public static final SurfaceBrick EMPTY =
      new SurfaceBrick(new float[0], new short[0], new int[0], new long[0]);

  private final float[] positionsMm;
  private final short[] normals;
  private final int[] triangles;
  private final long[] cells;

  SurfaceBrick(float[] positionsMm, short[] normals, int[] triangles, long[] cells) {
    this.positionsMm = positionsMm;
    this.normals = normals;
    this.triangles = triangles;
    this.cells = cells;
  }

  /**
   * Returns x, y, z of each vertex in grid mm. A vertex on the border of a brick has the same bits
   * in every brick that contains it.
   */
  public float[] positionsMm() {
    return positionsMm;
  }

  /**
   * Returns x, y, z of each normal and the ambient light, 1 if unoccluded, each times {@link
   * #FULL_SCALE}.
   */
  public short[] normals() {
    return normals;
  }

  /** Returns three vertices for each triangle, counter-clockwise seen from the empty side. */
  public int[] triangles() {
    return triangles;
  }

  /** Returns a key for each vertex, equal in every brick that contains it. */
  long[] cells() {
    return cells;
  }

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positionsMm.length / 3;
  }

  /** Returns the number of triangles. */
  public int triangleCount() {
    return triangles.length / 3;
  }

  /** Returns the size of the arrays, bytes. */
  public long bytes() {
    return 4L * positionsMm.length
        + 2L * normals.length
        + 4L * triangles.length
        + 8L * cells.length;
  }
}
