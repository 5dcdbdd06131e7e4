package org.palpate.elastic.lattice;

import java.util.Arrays;

/**
 * The stiffness of up to {@link #TILE} box-shaped trilinear hexahedra with Wilson's incompatible
 * modes, without a matrix. The displacement of a cell is a sum of the eight products of its local
 * coordinates, which run from -1 to 1. Bit a of the index of a product says whether coordinate a is
 * a factor. Strains that vary along different coordinates are orthogonal over a box, so few
 * products act on each other.
 *
 * <p>A cell that is partly full has the stiffness of its matter at the centre, with the second
 * moments of its matter. So a thin layer bends as such, in cells of any height.
 *
 * <p>Values stand in arrays over the cells of the tile. The loops over a tile are short, because
 * the compiler of JDK 17 turns short ones into vector code. One thread; allocates nothing after
 * construction.
 *
 * <p>Reference: Belytschko and Bindeman 1993, "Assumed strain stabilization of the eight node
 * hexahedral element".
 */
final class CellModes {
  /** The most cells; their arrays stay in the second-level cache. */
  static final int TILE = 256;

  private static final int ALL = 7;

  /**
   * Displacements or forces of the corners, by axis and corner; {@link #multiply} also keeps their
   * sums by axis and product here. Axes of the lattice.
   */
  final float[][][] values = new float[3][LatticeLayout.CORNERS][TILE];

  /** The modulus of each cell, N/mm^2. */
  final float[] modulus = new float[TILE];

  /** The second moment of each cell along each axis over that of a full cell. */
  final float[][] moment = new float[3][TILE];

  /** Entry 3 r + c of the rotation of each cell. */
  final float[][] rotation = new float[9][TILE];

  /** By axis and product, in the axes that turn with the cell. */
  private final float[][][] turned = new float[3][LatticeLayout.CORNERS][TILE];

  private final float[][] byCoordinate = new float[3][TILE];
  private final float[][] byTwo = new float[3][TILE];
  private final float[] trace = new float[TILE];
  private final float[][] shearStrain = new float[3][TILE];

  /** Eight times half an edge, by which corners at rest differ from their centre. */
  private final float[] restEdge = new float[3];

  /** The derivative of a local coordinate, 1/mm. */
  private final float[] slope = new float[3];

  private final float volume;
  private final float lambda;
  private final float shear;
  private final float planeStress;
  private final float poisson;

  /**
   * Creates the stiffness of cells of one size.
   *
   * @param poissonRatio of all cells
   */
  CellModes(double poissonRatio, LatticeLayout layout) {
    double mm3 = 1;
    for (int axis = 0; axis < 3; axis++) {
      restEdge[axis] = (float) (4 * layout.edgeMm(axis));
      slope[axis] = (float) (2 / layout.edgeMm(axis));
      mm3 *= layout.edgeMm(axis);
    }
    // Products come eight times too large from the corners, and go back to them so.
    volume = (float) (mm3 / 64);
    lambda = (float) (poissonRatio / ((1 + poissonRatio) * (1 - 2 * poissonRatio)));
    shear = (float) (1 / (2 * (1 + poissonRatio)));
    planeStress = (float) (1 / (1 - poissonRatio * poissonRatio));
    poisson = (float) poissonRatio;
  }

  /**
   * Replaces displacements of corners by the elastic forces on them.
   *
   * @param count the number of cells
   * @param fromRest whether the displacement is from the shape at rest, so that rotations matter;
   *     else it is one from a turned shape
   */
  void multiply(int count, boolean fromRest) {
    toProducts(count);
    if (fromRest) {
      addRest(values, 1, count);
    }
    for (int product = 1; product <= ALL; product++) {
      turn(product, count, values, turned, 3, 1);
    }
    if (fromRest) {
      addRest(turned, -1, count);
    }
    weigh(count);
    pullConstant(count);
    pullBent(count);
    pullSheared(count);
    pullTwisted(count);
    for (int product = 1; product <= ALL; product++) {
      turn(product, count, turned, values, 1, 3);
    }
    for (int axis = 0; axis < 3; axis++) {
      Arrays.fill(values[axis][0], 0, count, 0);
    }
    toCorners(count);
  }

  private void toProducts(int count) {
    for (int axis = 0; axis < 3; axis++) {
      for (int bit = 1; bit < LatticeLayout.CORNERS; bit *= 2) {
        for (int low = 0; low < LatticeLayout.CORNERS; low++) {
          if ((low & bit) == 0) {
            sumAndDifference(values[axis][low], values[axis][low | bit], count);
          }
        }
      }
    }
  }

  /**
   * Replaces two numbers by their sum and difference. The compiler makes vector code of this order
   * of the loads; with the lower number first it does not, and a whole product takes a quarter
   * longer.
   */
  private static void sumAndDifference(float[] low, float[] high, int count) {
    for (int t = 0; t < count; t++) {
      float b = high[t];
      float a = low[t];
      low[t] = b + a;
      high[t] = b - a;
    }
  }

  private void toCorners(int count) {
    for (int axis = 0; axis < 3; axis++) {
      for (int bit = 1; bit < LatticeLayout.CORNERS; bit *= 2) {
        for (int low = 0; low < LatticeLayout.CORNERS; low++) {
          if ((low & bit) == 0) {
            differenceAndSum(values[axis][low], values[axis][low | bit], count);
          }
        }
      }
    }
  }

  private static void differenceAndSum(float[] low, float[] high, int count) {
    for (int t = 0; t < count; t++) {
      float a = low[t];
      float b = high[t];
      low[t] = a - b;
      high[t] = a + b;
    }
  }

  private void addRest(float[][][] dest, float sign, int count) {
    for (int axis = 0; axis < 3; axis++) {
      float[] own = dest[axis][1 << axis];
      float edge = sign * restEdge[axis];
      for (int t = 0; t < count; t++) {
        own[t] += edge;
      }
    }
  }

  /** Turns a product by the matrix with these steps between rows and columns of the rotation. */
  private void turn(
      int product, int count, float[][][] from, float[][][] dest, int acrossStep, int downStep) {
    for (int axis = 0; axis < 3; axis++) {
      int first = axis * downStep;
      turn(
          rotation[first],
          rotation[first + acrossStep],
          rotation[first + 2 * acrossStep],
          from[0][product],
          from[1][product],
          from[2][product],
          count,
          dest[axis][product]);
    }
  }

  private static void turn(
      float[] a, float[] b, float[] c, float[] x, float[] y, float[] z, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] = a[t] * x[t] + b[t] * y[t] + c[t] * z[t];
    }
  }

  /** Multiplies moduli with the mean squares of the coordinates, and of the products of two. */
  private void weigh(int count) {
    for (int t = 0; t < count; t++) {
      modulus[t] *= volume;
    }
    for (int axis = 0; axis < 3; axis++) {
      scale(1f / 3, modulus, moment[axis], count, byCoordinate[axis]);
    }
    for (int axis = 0; axis < 3; axis++) {
      int next = (axis + 1) % 3;
      scale(1f / 3, byCoordinate[next], moment[(axis + 2) % 3], count, byTwo[axis]);
    }
  }

  private static void scale(float factor, float[] a, float[] b, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] = factor * a[t] * b[t];
    }
  }

  /** Replaces the gradients that are constant over a cell by their forces. */
  private void pullConstant(int count) {
    float[] xx = turned[0][1];
    float[] yy = turned[1][2];
    float[] zz = turned[2][4];
    float gx = lambda * slope[0];
    float gy = lambda * slope[1];
    float gz = lambda * slope[2];
    for (int t = 0; t < count; t++) {
      trace[t] = gx * xx[t] + gy * yy[t] + gz * zz[t];
    }
    for (int axis = 0; axis < 3; axis++) {
      pullNormal(slope[axis], turned[axis][1 << axis], count);
    }
    for (int a = 0; a < 3; a++) {
      for (int b = a + 1; b < 3; b++) {
        pullPair(slope[b], turned[a][1 << b], slope[a], turned[b][1 << a], count);
      }
    }
  }

  private void pullNormal(float g, float[] own, int count) {
    float twiceShear = 2 * shear * g;
    for (int t = 0; t < count; t++) {
      own[t] = g * modulus[t] * (trace[t] + twiceShear * own[t]);
    }
  }

  private void pullPair(float ga, float[] a, float gb, float[] b, int count) {
    for (int t = 0; t < count; t++) {
      float stress = shear * modulus[t] * (ga * a[t] + gb * b[t]);
      a[t] = ga * stress;
      b[t] = gb * stress;
    }
  }

  /**
   * Replaces the products of a coordinate with those along whose axes they displace. The normal
   * strains along the other two axes, which vary with the coordinate, are those of bending. The
   * incompatible modes leave no stress along the coordinate itself.
   */
  private void pullBent(int count) {
    for (int axis = 0; axis < 3; axis++) {
      int b = (axis + 1) % 3;
      int c = (axis + 2) % 3;
      float[] ofB = turned[b][1 << axis | 1 << b];
      float[] ofC = turned[c][1 << axis | 1 << c];
      bend(slope[b], ofB, slope[c], ofC, byCoordinate[axis], count);
    }
  }

  private void bend(float gb, float[] b, float gc, float[] c, float[] weight, int count) {
    float nu = poisson;
    for (int t = 0; t < count; t++) {
      float stretchB = gb * b[t];
      float stretchC = gc * c[t];
      float stiff = planeStress * weight[t];
      b[t] = gb * stiff * (stretchB + nu * stretchC);
      c[t] = gc * stiff * (stretchC + nu * stretchB);
    }
  }

  /** Replaces the products of two coordinates that displace along the third axis. */
  private void pullSheared(int count) {
    for (int axis = 0; axis < 3; axis++) {
      int b = (axis + 1) % 3;
      int c = (axis + 2) % 3;
      float[] ofB = turned[b][1 << axis | 1 << c];
      float[] ofC = turned[c][1 << axis | 1 << b];
      strain(slope[c], ofB, slope[b], ofC, byCoordinate[axis], count, shearStrain[axis]);
    }
    for (int axis = 0; axis < 3; axis++) {
      int b = (axis + 1) % 3;
      int c = (axis + 2) % 3;
      float[] own = turned[axis][1 << b | 1 << c];
      add(shear * slope[c], shearStrain[b], shear * slope[b], shearStrain[c], count, own);
    }
  }

  private static void strain(
      float ga, float[] a, float gb, float[] b, float[] weight, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] = weight[t] * (ga * a[t] + gb * b[t]);
    }
  }

  private static void add(float ga, float[] a, float gb, float[] b, int count, float[] dest) {
    for (int t = 0; t < count; t++) {
      dest[t] = ga * a[t] + gb * b[t];
    }
  }

  /** Replaces the products of all three coordinates. */
  private void pullTwisted(int count) {
    for (int axis = 0; axis < 3; axis++) {
      int b = (axis + 1) % 3;
      int c = (axis + 2) % 3;
      float along = (lambda + 2 * shear) * slope[axis] * slope[axis];
      float acrossB = shear * slope[b] * slope[b];
      float acrossC = shear * slope[c] * slope[c];
      float[] own = turned[axis][ALL];
      add(along, byTwo[axis], acrossB, byTwo[b], count, trace);
      add(1, trace, acrossC, byTwo[c], count, trace);
      scale(1, own, trace, count, own);
    }
  }
}
