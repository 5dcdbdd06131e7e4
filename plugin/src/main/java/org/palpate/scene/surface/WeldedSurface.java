package org.palpate.scene.surface;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;

/**
 * Bricks made one: every vertex once. Immutable by convention: its arrays are not to be changed.
 */
public final class WeldedSurface {
  private final float[] positionsMm;
  private final short[] normals;
  private final int[] triangles;

  private WeldedSurface(float[] positionsMm, short[] normals, int[] triangles) {
    this.positionsMm = positionsMm;
    this.normals = normals;
    this.triangles = triangles;
  }

  /** Welds the bricks of one source and one level. */
  public static WeldedSurface of(Collection<SurfaceBrick> bricks) {
    int vertices = 0;
    int corners = 0;
    for (SurfaceBrick brick : bricks) {
      vertices += brick.vertexCount();
      corners += brick.triangles().length;
    }
    Welder welder = new Welder(vertices, corners);
    bricks.forEach(welder::add);
    return welder.welded();
  }

  /** Several surfaces side by side, not welded to each other. */
  public static WeldedSurface together(List<WeldedSurface> parts) {
    WeldedSurface all =
        new WeldedSurface(
            new float[parts.stream().mapToInt(part -> part.positionsMm.length).sum()],
            new short[parts.stream().mapToInt(part -> part.normals.length).sum()],
            new int[parts.stream().mapToInt(part -> part.triangles.length).sum()]);
    int vertices = 0;
    int corners = 0;
    for (WeldedSurface part : parts) {
      System.arraycopy(part.positionsMm, 0, all.positionsMm, 3 * vertices, part.positionsMm.length);
      System.arraycopy(part.normals, 0, all.normals, 4 * vertices, part.normals.length);
      for (int corner : part.triangles) {
        all.triangles[corners++] = corner + vertices;
      }
      vertices += part.vertexCount();
    }
    return all;
  }

  /** x, y, z of each vertex, grid millimetres. */
  public float[] positionsMm() {
    return positionsMm;
  }

  /** As in {@link SurfaceBrick#normals}. */
  public short[] normals() {
    return normals;
  }

  /** Three vertices each, counter-clockwise seen from the empty side. */
  public int[] triangles() {
    return triangles;
  }

  public int vertexCount() {
    return positionsMm.length / 3;
  }

  public int triangleCount() {
    return triangles.length / 3;
  }

  /** The volume within, cubic millimetres. */
  public double volumeMm3() {
    double sum = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      double ax = x(t);
      double ay = y(t);
      double az = z(t);
      double cx = y(t + 1) * z(t + 2) - z(t + 1) * y(t + 2);
      double cy = z(t + 1) * x(t + 2) - x(t + 1) * z(t + 2);
      double cz = x(t + 1) * y(t + 2) - y(t + 1) * x(t + 2);
      sum += ax * cx + ay * cy + az * cz;
    }
    return sum / 6;
  }

  /** The area, square millimetres. */
  public double areaMm2() {
    double sum = 0;
    for (int t = 0; t < triangles.length; t += 3) {
      double ux = x(t + 1) - x(t);
      double uy = y(t + 1) - y(t);
      double uz = z(t + 1) - z(t);
      double vx = x(t + 2) - x(t);
      double vy = y(t + 2) - y(t);
      double vz = z(t + 2) - z(t);
      double cx = uy * vz - uz * vy;
      double cy = uz * vx - ux * vz;
      double cz = ux * vy - uy * vx;
      sum += Math.sqrt(cx * cx + cy * cy + cz * cz);
    }
    return sum / 2;
  }

  /** x of a triangle corner, by its place in {@link #triangles}. */
  double x(int corner) {
    return positionsMm[3 * triangles[corner]];
  }

  double y(int corner) {
    return positionsMm[3 * triangles[corner] + 1];
  }

  double z(int corner) {
    return positionsMm[3 * triangles[corner] + 2];
  }

  /** Numbers vertices by their cells in a hash table with open addressing. */
  private static final class Welder {
    private static final long FREE = -1;

    private final float[] positions;
    private final short[] normals;
    private final int[] triangles;
    private final long[] keys;
    private final int[] numbers;
    private int vertexCount;
    private int cornerCount;

    Welder(int vertices, int corners) {
      positions = new float[3 * vertices];
      normals = new short[4 * vertices];
      triangles = new int[corners];
      int capacity = Integer.highestOneBit(Math.max(8, 2 * vertices)) << 1;
      keys = new long[capacity];
      numbers = new int[capacity];
      Arrays.fill(keys, FREE);
    }

    void add(SurfaceBrick brick) {
      int[] welded = new int[brick.vertexCount()];
      for (int vertex = 0; vertex < welded.length; vertex++) {
        welded[vertex] = number(brick, vertex);
      }
      for (int corner : brick.triangles()) {
        triangles[cornerCount++] = welded[corner];
      }
    }

    private int number(SurfaceBrick brick, int vertex) {
      long key = brick.cells()[vertex];
      int slot = Long.hashCode(key * 0x9E3779B97F4A7C15L) & (keys.length - 1);
      while (keys[slot] != key && keys[slot] != FREE) {
        slot = (slot + 1) & (keys.length - 1);
      }
      if (keys[slot] == FREE) {
        keys[slot] = key;
        numbers[slot] = vertexCount;
        System.arraycopy(brick.positionsMm(), 3 * vertex, positions, 3 * vertexCount, 3);
        System.arraycopy(brick.normals(), 4 * vertex, normals, 4 * vertexCount, 4);
        vertexCount++;
      }
      return numbers[slot];
    }

    WeldedSurface welded() {
      return new WeldedSurface(
          Arrays.copyOf(positions, 3 * vertexCount),
          Arrays.copyOf(normals, 4 * vertexCount),
          triangles);
    }
  }
}
