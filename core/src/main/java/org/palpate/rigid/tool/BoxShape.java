package org.palpate.rigid.tool;

import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * A cuboid with its centre at the origin and its edges along the axes.
 *
 * @param edgeX edge along x, mm, positive
 * @param edgeY edge along y, mm, positive
 * @param edgeZ edge along z, mm, positive
 */
public record BoxShape(double edgeX, double edgeY, double edgeZ) implements ToolShape {
  /**
   * Checks the edges.
   *
   * @throws IllegalArgumentException if an edge is not positive and finite
   */
  public BoxShape {
    if (!(Math.min(edgeX, Math.min(edgeY, edgeZ)) > 0)
        || !(edgeX + edgeY + edgeZ < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException(
          "edges of a box must be positive: " + edgeX + ", " + edgeY + ", " + edgeZ);
    }
  }

  @Override
  public boolean contains(double x, double y, double z) {
    return 2 * Math.abs(x) <= edgeX && 2 * Math.abs(y) <= edgeY && 2 * Math.abs(z) <= edgeZ;
  }

  @Override
  public Vec3 low() {
    return new Vec3(-edgeX / 2, -edgeY / 2, -edgeZ / 2);
  }

  @Override
  public Vec3 high() {
    return new Vec3(edgeX / 2, edgeY / 2, edgeZ / 2);
  }

  @Override
  public double areaMm2() {
    return 2 * (edgeX * edgeY + edgeY * edgeZ + edgeZ * edgeX);
  }

  @Override
  public MassProperties massProperties() {
    double[] covariance = {edgeX * edgeX / 12, edgeY * edgeY / 12, edgeZ * edgeZ / 12, 0, 0, 0};
    return new MassProperties(edgeX * edgeY * edgeZ, new Vec3(), covariance);
  }

  @Override
  public Optional<ToolShape> eroded(double depthMm) {
    double x = edgeX - 2 * depthMm;
    double y = edgeY - 2 * depthMm;
    double z = edgeZ - 2 * depthMm;
    boolean isLeft = Math.min(x, Math.min(y, z)) > 0;
    return isLeft ? Optional.of(new BoxShape(x, y, z)) : Optional.empty();
  }

  /** {@inheritDoc} The samples are the nodes of a lattice whose cells have that half diagonal. */
  @Override
  public void sampleSurface(double coverRadiusMm, PointSink sink) {
    double step = coverRadiusMm * Math.sqrt(2);
    int cellsX = cells(edgeX, step);
    int cellsY = cells(edgeY, step);
    int cellsZ = cells(edgeZ, step);
    for (int k = 0; k <= cellsZ; k++) {
      for (int j = 0; j <= cellsY; j++) {
        boolean onSide = k == 0 || k == cellsZ || j == 0 || j == cellsY;
        for (int i = 0; i <= cellsX; i += onSide ? 1 : cellsX) {
          sink.add(node(edgeX, i, cellsX), node(edgeY, j, cellsY), node(edgeZ, k, cellsZ));
        }
      }
    }
  }

  private static int cells(double edge, double step) {
    return Math.max(1, (int) Math.ceil(edge / step));
  }

  private static double node(double edge, int index, int cells) {
    return edge * index / cells - edge / 2;
  }
}
