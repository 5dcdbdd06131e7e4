package org.palpate.force.guide;

import java.util.List;
import org.palpate.geometry.Vec3;

/** A path of straight pieces through given positions. Cost of a query: linear in the pieces. */
public final class PathShape implements GuideShape {
  /** The most positions, so that the work of a frame stays small. */
  public static final int MOST_POSITIONS = 1000;

  private final double[] x;
  private final double[] y;
  private final double[] z;

  /**
   * Creates a path.
   *
   * @param positions its positions in order, mm, 2 to {@link #MOST_POSITIONS}
   * @throws IllegalArgumentException if there are fewer or more
   */
  public PathShape(List<Vec3> positions) {
    if (positions.size() < 2 || positions.size() > MOST_POSITIONS) {
      throw new IllegalArgumentException(
          "a path has 2 to " + MOST_POSITIONS + " positions: positions=" + positions.size());
    }
    x = new double[positions.size()];
    y = new double[x.length];
    z = new double[x.length];
    for (int n = 0; n < x.length; n++) {
      x[n] = positions.get(n).x;
      y[n] = positions.get(n).y;
      z[n] = positions.get(n).z;
    }
  }

  @Override
  public void nearest(Vec3 position, Vec3 dest) {
    int best = 0;
    double bestFraction = 0;
    double least = Double.POSITIVE_INFINITY;
    for (int n = 0; n + 1 < x.length; n++) {
      double fraction = fraction(n, position);
      double square = squareTo(n, fraction, position);
      if (square < least) {
        least = square;
        best = n;
        bestFraction = fraction;
      }
    }
    dest.set(
        x[best] + bestFraction * (x[best + 1] - x[best]),
        y[best] + bestFraction * (y[best + 1] - y[best]),
        z[best] + bestFraction * (z[best + 1] - z[best]));
  }

  /** Returns where on a piece, from 0 to 1, the nearest position lies. */
  private double fraction(int piece, Vec3 position) {
    double alongX = x[piece + 1] - x[piece];
    double alongY = y[piece + 1] - y[piece];
    double alongZ = z[piece + 1] - z[piece];
    double square = alongX * alongX + alongY * alongY + alongZ * alongZ;
    double dot =
        (position.x - x[piece]) * alongX
            + (position.y - y[piece]) * alongY
            + (position.z - z[piece]) * alongZ;
    return square > 0 ? Math.max(0, Math.min(1, dot / square)) : 0;
  }

  private double squareTo(int piece, double fraction, Vec3 position) {
    double gapX = x[piece] + fraction * (x[piece + 1] - x[piece]) - position.x;
    double gapY = y[piece] + fraction * (y[piece + 1] - y[piece]) - position.y;
    double gapZ = z[piece] + fraction * (z[piece + 1] - z[piece]) - position.z;
    return gapX * gapX + gapY * gapY + gapZ * gapZ;
  }
}
