package org.palpate.elastic;

import java.util.Arrays;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Quick bounds for all cells of a field at once: how far the edges of a tetrahedron are from those
 * at rest, and how far the answers to unit forces move them. {@link RoomProof} looks closely only
 * at cells for which these bounds do not suffice.
 *
 * <p>A tetrahedron has one edge along each axis. So the sum over the axes, each with the largest
 * square of the four edges of its cell, bounds the sum over its own edges. Only positive floats are
 * added, the squares of differences, so a bound is rounded by less than 1e-5 of itself.
 *
 * <p>All loops have one index for all arrays, so that the compiler makes vector code; edges are
 * copied for that. One thread; allocates nothing after construction.
 */
final class CellBounds {
  private static final int ANSWERS = 3;
  private final LatticeLayout layout;
  private final int nodes;
  private final float[] own;
  private final float[] shifted;
  private final float[] edges;
  private final float[] answerEdges;

  /** The bound that {@link #squaredDeviation} returns, by the first node of a cell. */
  private final float[] deviations;

  private final float[] answers;
  private final float[] earlierDeviations;
  private final float[] earlierAnswers;

  CellBounds(LatticeLayout layout) {
    this.layout = layout;
    nodes = layout.nodeCount();
    own = new float[nodes];
    shifted = new float[nodes];
    edges = new float[nodes];
    answerEdges = new float[nodes];
    deviations = new float[nodes];
    answers = new float[nodes];
    earlierDeviations = new float[nodes];
    earlierAnswers = new float[nodes];
  }

  /**
   * Reads the values of a field.
   *
   * @param blended whether the field is blended with the field before: then the bounds hold for
   *     both
   */
  void read(DeformationField.NodeValues field, boolean blended) {
    read(field.values, deviations, answers);
    if (blended) {
      read(field.earlier, earlierDeviations, earlierAnswers);
      raise(earlierDeviations, deviations);
      raise(earlierAnswers, answers);
    }
  }

  /**
   * Returns the square of a bound of |F - F0| for each tetrahedron of a cell, where F has its edges
   * as columns, and F0 those at rest, in cells; NaN if a displacement is NaN.
   */
  double squaredDeviation(int firstNode) {
    return deviations[firstNode];
  }

  /**
   * Returns a bound of the sum of the squares of the changes of F by the answers to the three unit
   * forces, for each tetrahedron of a cell.
   */
  double squaredAnswers(int firstNode) {
    return answers[firstNode];
  }

  private void read(float[] values, float[] deviationDest, float[] answerDest) {
    Arrays.fill(deviationDest, 0);
    Arrays.fill(answerDest, 0);
    for (int axis = 0; axis < 3; axis++) {
      Arrays.fill(edges, 0);
      Arrays.fill(answerEdges, 0);
      for (int component = 0; component < DeformationField.STRIDE; component++) {
        addEdges(values, component, axis, component < ANSWERS ? edges : answerEdges);
      }
      addLongest(edges, axis, deviationDest);
      addLongest(answerEdges, axis, answerDest);
    }
  }

  /** Adds the squares of a component of the edges along an axis, by the node where they begin. */
  private void addEdges(float[] values, int component, int axis, float[] dest) {
    for (int node = 0; node < nodes; node++) {
      own[node] = values[DeformationField.STRIDE * node + component];
    }
    shift(own, layout.cornerOffset(1 << axis));
    addSquares(shifted, own, dest);
  }

  private static void addSquares(float[] to, float[] from, float[] dest) {
    for (int n = 0; n < dest.length; n++) {
      float difference = to[n] - from[n];
      dest[n] += difference * difference;
    }
  }

  /** Adds for each cell the largest of the squares of its four edges along an axis. */
  private void addLongest(float[] squares, int axis, float[] dest) {
    for (int across = 0; across < 3; across++) {
      if (across != axis) {
        shift(squares, layout.cornerOffset(1 << across));
        raise(shifted, squares);
      }
    }
    for (int n = 0; n < dest.length; n++) {
      dest[n] += squares[n];
    }
  }

  /** Copies numbers of later nodes; what no cell needs stays as it is. */
  private void shift(float[] from, int by) {
    System.arraycopy(from, by, shifted, 0, nodes - by);
  }

  private static void raise(float[] to, float[] dest) {
    for (int n = 0; n < dest.length; n++) {
      dest[n] = Math.max(dest[n], to[n]);
    }
  }
}
