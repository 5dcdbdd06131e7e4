package org.palpate.scene.surface;

/**
 * The triangles of one brick of cells. Immutable by convention: its arrays are not to be changed.
 */
public final class SurfaceBrick {
  /** The most that a component of a normal, and openness, can be. */
  public static final int FULL_SCALE = Short.MAX_VALUE;

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
   * x, y, z of each vertex, grid millimetres; a vertex on a brick border has the same bits in every
   * brick that holds it.
   */
  public float[] positionsMm() {
    return positionsMm;
  }

  /**
   * x, y, z of each normal times {@link #FULL_SCALE}, and how open the place is to light, {@link
   * #FULL_SCALE} for wholly.
   */
  public short[] normals() {
    return normals;
  }

  /** Three vertices each, counter-clockwise seen from the empty side. */
  public int[] triangles() {
    return triangles;
  }

  /** Which vertex of the whole surface each one is, equal in every brick that holds it. */
  long[] cells() {
    return cells;
  }

  public int vertexCount() {
    return positionsMm.length / 3;
  }

  public int triangleCount() {
    return triangles.length / 3;
  }

  /** Memory held, bytes. */
  public long bytes() {
    return 4L * positionsMm.length
        + 2L * normals.length
        + 4L * triangles.length
        + 8L * cells.length;
  }
}
