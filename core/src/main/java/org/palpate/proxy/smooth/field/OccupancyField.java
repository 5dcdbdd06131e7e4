package org.palpate.proxy.smooth.field;

import org.palpate.collision.CollisionScene;
import org.palpate.geometry.Vec3;

/**
 * The smoothed share of solid around a point: 0 in the open, 1 deep inside, about a half where the
 * surface runs. Twice differentiable in pieces; value, gradient and Hessian come from 27 quadratic
 * B-splines.
 *
 * <p>A point is evaluated as the window around its nearest corner shows it, after what the seed
 * cannot reach there was taken for solid. For a given seed and given solids the answer depends on
 * the point alone, to the last bit: what is kept from call to call only saves time.
 */
public final class OccupancyField {
  /** The share of solid at the point that was evaluated last. */
  public double value;

  /** Changes whenever value and derivatives do. */
  public long evaluation;

  /** How many windows of voxels were read so far: most of what an evaluation takes. */
  public long windows;

  /** Its gradient, a metric edge. */
  public double gx;

  public double gy;
  public double gz;

  /** Its second derivatives, a metric edge squared. */
  public double hxx;

  public double hyy;
  public double hzz;
  public double hxy;
  public double hxz;
  public double hyz;

  private final CoefficientSource source;
  private final double inverseX;
  private final double inverseY;
  private final double inverseZ;
  private final double[] nodes = new double[27];
  private CollisionScene obstacles;
  private int seedX;
  private int seedY;
  private int seedZ;
  private int cornerX;
  private int cornerY;
  private int cornerZ;
  private boolean loaded;
  private boolean any;

  /** Whether what was evaluated last holds for the seed that was set last. */
  private boolean settled;

  private final Vec3 evaluated = new Vec3();

  /**
   * A field.
   *
   * @param edges edges of a voxel, in shortest edges: at least 1
   */
  public OccupancyField(CoefficientSource source, Vec3 edges) {
    this.source = source;
    inverseX = 1 / edges.x;
    inverseY = 1 / edges.y;
    inverseZ = 1 / edges.z;
  }

  /** Forgets what is kept of the solids. */
  public void forget() {
    loaded = false;
    settled = false;
    source.forget();
  }

  /** Sets the solids; others than last time are read anew. */
  public void use(CollisionScene newObstacles) {
    if (obstacles != newObstacles) {
      obstacles = newObstacles;
      forget();
    }
  }

  /** Sets the point from which empty space is reached, grid coordinates; its cell is empty. */
  public void seed(double x, double y, double z) {
    int cellX = floor(x);
    int cellY = floor(y);
    int cellZ = floor(z);
    settled &= cellX == seedX && cellY == seedY && cellZ == seedZ;
    seedX = cellX;
    seedY = cellY;
    seedZ = cellZ;
  }

  /** Evaluates at a point in grid coordinates, at most 1e9 from 0. */
  public void evaluate(double x, double y, double z) {
    if (settled && x == evaluated.x && y == evaluated.y && z == evaluated.z) {
      return;
    }
    int atX = floor(x + 0.5);
    int atY = floor(y + 0.5);
    int atZ = floor(z + 0.5);
    boolean kept =
        loaded
            && atX == cornerX
            && atY == cornerY
            && atZ == cornerZ
            && source.holdsFor(seedX, seedY, seedZ);
    if (!kept) {
      windows++;
      any = source.load(obstacles, atX, atY, atZ, seedX, seedY, seedZ, nodes);
      cornerX = atX;
      cornerY = atY;
      cornerZ = atZ;
      loaded = true;
    }
    settled = true;
    if (kept && x == evaluated.x && y == evaluated.y && z == evaluated.z) {
      return;
    }
    evaluated.set(x, y, z);
    evaluation++;
    clear();
    if (any) {
      sum(x - atX, y - atY, z - atZ);
    }
  }

  private static int floor(double v) {
    int whole = (int) v;
    return v < whole ? whole - 1 : whole;
  }

  /** Sums the splines, x first; u, v, w from the nearest corner, from -0.5 to 0.5. */
  private void sum(double u, double v, double w) {
    double x0 = 0.5 * (0.5 - u) * (0.5 - u);
    double x1 = 0.75 - u * u;
    double x2 = 0.5 * (0.5 + u) * (0.5 + u);
    double dx0 = u - 0.5;
    double dx1 = -2 * u;
    double dx2 = u + 0.5;
    double y0 = 0.5 * (0.5 - v) * (0.5 - v);
    double y1 = 0.75 - v * v;
    double y2 = 0.5 * (0.5 + v) * (0.5 + v);
    double dy0 = v - 0.5;
    double dy1 = -2 * v;
    double dy2 = v + 0.5;
    for (int layer = 0; layer < 3; layer++) {
      int n = 9 * layer;
      double r0 = nodes[n] * x0 + nodes[n + 1] * x1 + nodes[n + 2] * x2;
      double r1 = nodes[n + 3] * x0 + nodes[n + 4] * x1 + nodes[n + 5] * x2;
      double r2 = nodes[n + 6] * x0 + nodes[n + 7] * x1 + nodes[n + 8] * x2;
      double s0 = nodes[n] * dx0 + nodes[n + 1] * dx1 + nodes[n + 2] * dx2;
      double s1 = nodes[n + 3] * dx0 + nodes[n + 4] * dx1 + nodes[n + 5] * dx2;
      double s2 = nodes[n + 6] * dx0 + nodes[n + 7] * dx1 + nodes[n + 8] * dx2;
      double q0 = nodes[n] - 2 * nodes[n + 1] + nodes[n + 2];
      double q1 = nodes[n + 3] - 2 * nodes[n + 4] + nodes[n + 5];
      double q2 = nodes[n + 6] - 2 * nodes[n + 7] + nodes[n + 8];
      double f = r0 * y0 + r1 * y1 + r2 * y2;
      double fx = s0 * y0 + s1 * y1 + s2 * y2;
      double fy = r0 * dy0 + r1 * dy1 + r2 * dy2;
      double fxx = q0 * y0 + q1 * y1 + q2 * y2;
      double fxy = s0 * dy0 + s1 * dy1 + s2 * dy2;
      double fyy = r0 - 2 * r1 + r2;
      addLayer(layer, w, f, fx, fy, fxx, fxy, fyy);
    }
    toMetric();
  }

  private void clear() {
    value = gx = gy = gz = hxx = hyy = hzz = hxy = hxz = hyz = 0;
  }

  private void addLayer(
      int layer, double w, double f, double fx, double fy, double fxx, double fxy, double fyy) {
    double weight;
    double slope;
    double bend;
    if (layer == 1) {
      weight = 0.75 - w * w;
      slope = -2 * w;
      bend = -2;
    } else {
      double side = layer - 1;
      weight = 0.5 * (0.5 + side * w) * (0.5 + side * w);
      slope = w + 0.5 * side;
      bend = 1;
    }
    value += f * weight;
    gx += fx * weight;
    gy += fy * weight;
    gz += f * slope;
    hxx += fxx * weight;
    hxy += fxy * weight;
    hyy += fyy * weight;
    hxz += fx * slope;
    hyz += fy * slope;
    hzz += f * bend;
  }

  private void toMetric() {
    gx *= inverseX;
    gy *= inverseY;
    gz *= inverseZ;
    hxx *= inverseX * inverseX;
    hyy *= inverseY * inverseY;
    hzz *= inverseZ * inverseZ;
    hxy *= inverseX * inverseY;
    hxz *= inverseX * inverseZ;
    hyz *= inverseY * inverseZ;
  }

  /** The standard deviation of the smoothing along an axis, in shortest voxel edges. */
  double sigmaEdges(int axis) {
    return source.sigmaEdges(axis);
  }
}
