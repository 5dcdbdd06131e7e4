package org.palpate.scene.surface;

import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A surface without duplicate vertices, welded from bricks. Immutable by convention: its arrays are
 * read-only.
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

  /** Combines several surfaces without welding them to each other. */
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

  /**
   * Returns this surface as its body moves it, in another frame of the vertices.
   *
   * @param motion the pose of the body, from rest to present, world mm
   * @param ownMmToWorld from the present frame of the vertices to the world at rest
   * @param gridMmToWorld from the new frame of the vertices to the world
   */
  public WeldedSurface moved(
      Pose motion, RigidTransform ownMmToWorld, RigidTransform gridMmToWorld) {
    float[] positions = positionsMm.clone();
    short[] turned = normals.clone();
    Vec3 v = new Vec3();
    for (int n = 0; n < vertexCount(); n++) {
      v.set(positions[3 * n], positions[3 * n + 1], positions[3 * n + 2]);
      motion.transform(ownMmToWorld.transform(v, v), v);
      gridMmToWorld.inverseTransform(v, v);
      for (int axis = 0; axis < 3; axis++) {
        positions[3 * n + axis] = (float) v.get(axis);
      }
      v.set(turned[4 * n], turned[4 * n + 1], turned[4 * n + 2]);
      motion.rotation.rotate(ownMmToWorld.rotate(v, v), v);
      gridMmToWorld.inverseRotate(v, v);
      for (int axis = 0; axis < 3; axis++) {
        turned[4 * n + axis] = (short) Math.rint(v.get(axis));
      }
    }
    boolean mirrors = ownMmToWorld.isMirrored() != gridMmToWorld.isMirrored();
    return new WeldedSurface(positions, turned, mirrors ? turnedOver() : triangles);
  }

  /** Returns the triangles with their corners in the opposite order. */
  private int[] turnedOver() {
    int[] over = triangles.clone();
    for (int n = 0; n < over.length; n += 3) {
      over[n + 1] = triangles[n + 2];
      over[n + 2] = triangles[n + 1];
    }
    return over;
  }

  /** Returns x, y, z of each vertex in grid mm. */
  public float[] positionsMm() {
    return positionsMm;
  }

  /** Returns normals and ambient light as {@link SurfaceBrick#normals} does. */
  public short[] normals() {
    return normals;
  }

  /** Returns three vertices for each triangle, counter-clockwise seen from the empty side. */
  public int[] triangles() {
    return triangles;
  }

  /** Returns the number of vertices. */
  public int vertexCount() {
    return positionsMm.length / 3;
  }

  /** Returns the number of triangles. */
  public int triangleCount() {
    return triangles.length / 3;
  }

  /** Collects vertices and triangles, each vertex once. */
  private static final class Welder {
    private final float[] positions;
    private final short[] normals;
    private final int[] triangles;
    private final VertexNumbers numbers;
    private int cornerCount;

    Welder(int vertices, int corners) {
      positions = new float[3 * vertices];
      normals = new short[4 * vertices];
      triangles = new int[corners];
      numbers = new VertexNumbers(vertices);
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
      int count = numbers.count();
      int number = numbers.number(brick.cells()[vertex]);
      if (number == count) {
        System.arraycopy(brick.positionsMm(), 3 * vertex, positions, 3 * count, 3);
        System.arraycopy(brick.normals(), 4 * vertex, normals, 4 * count, 4);
      }
      return number;
    }

    WeldedSurface welded() {
      return new WeldedSurface(
          Arrays.copyOf(positions, 3 * numbers.count()),
          Arrays.copyOf(normals, 4 * numbers.count()),
          triangles);
    }
  }
}
