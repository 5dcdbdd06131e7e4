package org.palpate.rigid.tool;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/**
 * A surface of triangles, mm. Vertices with the same coordinates are one vertex, and triangles with
 * two equal vertices are left out.
 *
 * <p>A mesh is closed if its triangles bound a solid: each edge is used as often in one direction
 * as in the other. If each edge is used twice and only directions disagree, triangles are flipped,
 * and cavities are filled because nothing distinguishes them from solids. Immutable; any thread.
 */
public final class TriangleMesh {
  private final double[] coordinates;
  private final int[] corners;
  private final boolean isClosed;

  /**
   * Creates a mesh.
   *
   * @param coordinates x, y and z of each vertex, mm, finite; not kept
   * @param corners the indices of the three vertices of each triangle; not kept
   * @throws IllegalArgumentException if no triangle is left
   */
  public TriangleMesh(double[] coordinates, int[] corners) {
    VertexWelder welder = new VertexWelder(coordinates);
    this.coordinates = welder.coordinates();
    this.corners = welder.weld(corners);
    if (this.corners.length == 0) {
      throw new IllegalArgumentException("a mesh needs at least one triangle with an area");
    }
    MeshEdges edges = new MeshEdges(this.corners);
    boolean isBalanced = edges.isBalanced();
    isClosed = isBalanced || edges.orient();
    if (isClosed) {
      turnOutward(edges, isBalanced);
    }
  }

  /** Flips the mesh, or each part of a repaired mesh, if its volume is negative. */
  private void turnOutward(MeshEdges edges, boolean asOne) {
    double[] volume = new double[triangleCount()];
    Vec3 origin = low();
    Vec3[] t = {new Vec3(), new Vec3(), new Vec3()};
    for (int n = 0; n < volume.length; n++) {
      MeshMoments moments = new MeshMoments(origin);
      moments.addTetrahedron(corner(n, 0, t[0]), corner(n, 1, t[1]), corner(n, 2, t[2]));
      volume[asOne ? 0 : edges.component(n)] += moments.size();
    }
    for (int n = 0; n < volume.length; n++) {
      if (volume[asOne ? 0 : edges.component(n)] < 0) {
        edges.flip(n);
      }
    }
  }

  /** {@return whether the triangles bound a solid} */
  public boolean isClosed() {
    return isClosed;
  }

  /** {@return the number of triangles} */
  public int triangleCount() {
    return corners.length / 3;
  }

  /**
   * Writes a corner of a triangle.
   *
   * @param triangle the number of the triangle, from 0
   * @param index the number of the corner: 0, 1 or 2
   * @param dest receives the corner, mm
   * @return {@code dest}
   */
  public Vec3 corner(int triangle, int index, Vec3 dest) {
    int at = 3 * corners[3 * triangle + index];
    return dest.set(coordinates[at], coordinates[at + 1], coordinates[at + 2]);
  }

  /** {@return the low corner of the box around the mesh, mm} */
  public Vec3 low() {
    return new Vec3(least(0, 1), least(1, 1), least(2, 1));
  }

  /** {@return the high corner of the box around the mesh, mm} */
  public Vec3 high() {
    return new Vec3(-least(0, -1), -least(1, -1), -least(2, -1));
  }

  private double least(int axis, int sign) {
    double least = Double.POSITIVE_INFINITY;
    for (int corner : corners) {
      least = Math.min(least, sign * coordinates[3 * corner + axis]);
    }
    return least;
  }

  /** {@return the area, mm^2} */
  public double areaMm2() {
    Vec3 a = new Vec3();
    Vec3 b = new Vec3();
    Vec3 c = new Vec3();
    double area = 0;
    for (int n = 0; n < triangleCount(); n++) {
      area += TriangleMath.area(corner(n, 0, a), corner(n, 1, b), corner(n, 2, c));
    }
    return area;
  }

  /** Returns the mass properties of the solid if the mesh is closed, and of its surface if not. */
  MassProperties massProperties() {
    MassProperties solid = isClosed ? volumeProperties() : null;
    return solid != null && solid.volumeMm3() > 0 ? solid : surfaceProperties();
  }

  private MassProperties volumeProperties() {
    Vec3 origin = low().add(high(), new Vec3()).mul(0.5, new Vec3());
    MeshMoments moments = new MeshMoments(origin);
    Vec3[] t = {new Vec3(), new Vec3(), new Vec3()};
    for (int n = 0; n < triangleCount(); n++) {
      moments.addTetrahedron(corner(n, 0, t[0]), corner(n, 1, t[1]), corner(n, 2, t[2]));
    }
    return moments.massProperties();
  }

  private MassProperties surfaceProperties() {
    MeshMoments moments = new MeshMoments(low());
    Vec3[] t = {new Vec3(), new Vec3(), new Vec3()};
    for (int n = 0; n < triangleCount(); n++) {
      moments.addTriangle(corner(n, 0, t[0]), corner(n, 1, t[1]), corner(n, 2, t[2]));
    }
    return moments.massProperties();
  }

  /** {@return a copy of the vertices, x, y and z of each, mm} */
  public double[] coordinates() {
    return Arrays.copyOf(coordinates, coordinates.length);
  }

  /** {@return a copy of the indices of the vertices, three for each triangle} */
  public int[] corners() {
    return Arrays.copyOf(corners, corners.length);
  }
}
