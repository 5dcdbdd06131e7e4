package org.palpate.benchmarks.elastic;

import java.math.BigDecimal;
import java.util.Optional;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.ElasticBodyVariants;
import org.palpate.elastic.lattice.LatticeLayout;

/**
 * Decides exactly whether the tetrahedra of a deformation are positive: the six of each cell that
 * follow its edges from corner 0 to corner 7. It decides in doubles if an error bound allows, and
 * else in decimal fractions. It shares no code with the proof that it judges. One thread.
 */
final class TetrahedronJudge {
  /**
   * More than the relative error of a sum of six products of three rounded differences, over the
   * sum of their sizes.
   */
  private static final double RELATIVE_ERROR = 0x1p-48;

  private final double[][] corner = new double[LatticeLayout.CORNERS][3];
  private final double[] a = new double[3];
  private final double[] b = new double[3];
  private final double[] c = new double[3];
  private long judged;
  private long notPositive;
  private long exactDecisions;
  private long windows;

  /**
   * Judges all cells of the lattice, as the haptic thread would use them now. Those of a window
   * take the place of the ones under it.
   */
  void judge(ElasticBody body) {
    Optional<LatticeLayout> window = ElasticBodyVariants.windowLayout(body);
    judge(
        ElasticBodyVariants.layout(body),
        (x, y, z) -> window.isEmpty() || !ElasticBodyVariants.isInWindow(body, x, y, z),
        (node, axis) -> ElasticBodyVariants.nodePosition(body, node, axis));
    if (window.isPresent()) {
      windows++;
      judge(
          window.get(),
          (x, y, z) -> true,
          (node, axis) -> ElasticBodyVariants.windowPosition(body, node, axis));
    }
  }

  /** Chooses cells. */
  private interface Choice {
    boolean takes(int x, int y, int z);
  }

  /** The present position of a node along an axis, in cells. */
  private interface Present {
    double of(int node, int axis);
  }

  private void judge(LatticeLayout layout, Choice choice, Present present) {
    for (int z = 0; z < layout.cells(2); z++) {
      for (int y = 0; y < layout.cells(1); y++) {
        for (int x = 0; x < layout.cells(0); x++) {
          if (choice.takes(x, y, z)) {
            judge(layout, present, x, y, z);
          }
        }
      }
    }
  }

  private void judge(LatticeLayout layout, Present present, int x, int y, int z) {
    for (int n = 0; n < corner.length; n++) {
      int node = layout.node(x + (n & 1), y + (n >> 1 & 1), z + (n >> 2));
      for (int axis = 0; axis < 3; axis++) {
        corner[n][axis] = present.of(node, axis);
      }
    }
    judge(corner);
  }

  /** Judges the tetrahedra of a cell with these corners. */
  void judge(double[][] corners) {
    for (int first = 0; first < 3; first++) {
      for (int second = 0; second < 3; second++) {
        if (first != second) {
          int middle = 1 << first;
          int next = middle | 1 << second;
          boolean cyclic = second == (first + 1) % 3;
          int sign = sign(corners[0], corners[middle], corners[next], corners[7]);
          judged++;
          notPositive += (cyclic ? sign : -sign) > 0 ? 0 : 1;
        }
      }
    }
  }

  /** Returns the sign of the determinant of the edges p to q, q to r and r to s. */
  private int sign(double[] p, double[] q, double[] r, double[] s) {
    for (int axis = 0; axis < 3; axis++) {
      a[axis] = q[axis] - p[axis];
      b[axis] = r[axis] - q[axis];
      c[axis] = s[axis] - r[axis];
    }
    double value = 0;
    double size = 0;
    for (int axis = 0; axis < 3; axis++) {
      int u = (axis + 1) % 3;
      int v = (axis + 2) % 3;
      double plus = a[axis] * b[u] * c[v];
      double minus = a[axis] * b[v] * c[u];
      value += plus - minus;
      size += Math.abs(plus) + Math.abs(minus);
    }
    return Math.abs(value) > size * RELATIVE_ERROR
        ? (int) Math.signum(value)
        : exactSign(p, q, r, s);
  }

  private int exactSign(double[] p, double[] q, double[] r, double[] s) {
    exactDecisions++;
    BigDecimal value = BigDecimal.ZERO;
    for (int axis = 0; axis < 3; axis++) {
      int u = (axis + 1) % 3;
      int v = (axis + 2) % 3;
      BigDecimal minor =
          edge(q, r, u).multiply(edge(r, s, v)).subtract(edge(q, r, v).multiply(edge(r, s, u)));
      value = value.add(edge(p, q, axis).multiply(minor));
    }
    return value.signum();
  }

  private static BigDecimal edge(double[] from, double[] to, int axis) {
    return new BigDecimal(to[axis]).subtract(new BigDecimal(from[axis]));
  }

  long judged() {
    return judged;
  }

  long notPositive() {
    return notPositive;
  }

  /** Returns how many of the judged deformations had a window. */
  long windows() {
    return windows;
  }

  /** Returns how often doubles did not suffice. */
  long exactDecisions() {
    return exactDecisions;
  }
}
