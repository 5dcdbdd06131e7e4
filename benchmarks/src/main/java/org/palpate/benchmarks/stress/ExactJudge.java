package org.palpate.benchmarks.stress;

import java.math.BigDecimal;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Decides exactly whether the segment between two points touches a closed solid voxel, fast enough
 * for a billion legs. It is independent of the casters that it judges: it does not traverse the
 * grid, but tests every solid voxel in the segment's bounding box with separating planes.
 *
 * <p>A segment and a box are separate if their extents along an axis are, or if all corners of the
 * box, projected along an axis, lie on one side of the segment's line. Sides are signs of a*b -
 * c*d, computed in doubles if an error bound allows and otherwise in unlimited decimal fractions.
 * For one thread.
 */
public final class ExactJudge {
  /**
   * Twice the relative error of a product of two differences of doubles, and of the difference of
   * two such products: 4 units in the last place of each.
   */
  private static final double RELATIVE_ERROR = 0x1p-50;

  /** Products below this may have lost bits to underflow. */
  private static final double MIN_RELIABLE = 0x1p-900;

  private final double[] from = new double[3];
  private final double[] to = new double[3];
  private final int[] low = new int[3];
  private final int[] high = new int[3];
  private final int[] cell = new int[3];
  private final boolean filtered;
  private long exactDecisions;

  /** Creates a judge that decides in doubles where an error bound allows. */
  public ExactJudge() {
    this(true);
  }

  private ExactJudge(boolean filtered) {
    this.filtered = filtered;
  }

  /** Returns a judge that decides every side in decimal fractions, to check the filter with. */
  public static ExactJudge unfiltered() {
    return new ExactJudge(false);
  }

  /** Returns how often doubles did not suffice. */
  public long exactDecisions() {
    return exactDecisions;
  }

  /** Whether a leg touches a solid voxel. */
  public boolean touches(BitCube bits, LegPath legs, int leg) {
    for (int axis = 0; axis < 3; axis++) {
      from[axis] = legs.start(leg, axis);
      to[axis] = legs.end(leg, axis);
    }
    return touchesAny(bits);
  }

  /** Whether a ray touches a solid voxel. */
  public boolean touches(BitCube bits, Ray ray) {
    from[0] = ray.fromX;
    from[1] = ray.fromY;
    from[2] = ray.fromZ;
    to[0] = ray.toX;
    to[1] = ray.toY;
    to[2] = ray.toZ;
    return touchesAny(bits);
  }

  private boolean touchesAny(BitCube bits) {
    extent(0, bits.sizeX());
    extent(1, bits.sizeY());
    extent(2, bits.sizeZ());
    for (int z = low[2] >> 2; z <= high[2] >> 2; z++) {
      for (int y = low[1] >> 2; y <= high[1] >> 2; y++) {
        for (int x = low[0] >> 2; x <= high[0] >> 2; x++) {
          long word = bits.brick(x, y, z);
          if (word != 0 && touchesBrick(word, x << 2, y << 2, z << 2)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Computes the closed voxels whose extent along an axis meets the segment's. Exact. */
  private void extent(int axis, int size) {
    double least = Math.min(from[axis], to[axis]);
    double most = Math.max(from[axis], to[axis]);
    double first = Math.floor(least);
    low[axis] = (int) Math.max(0, first == least ? first - 1 : first);
    high[axis] = (int) Math.min(size - 1, Math.floor(most));
  }

  private boolean touchesBrick(long word, int x, int y, int z) {
    for (long rest = word; rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      cell[0] = x + (bit & 3);
      cell[1] = y + (bit >> 2 & 3);
      cell[2] = z + (bit >> 4);
      if (isInExtent() && !isApart(0, 1) && !isApart(1, 2) && !isApart(2, 0)) {
        return true;
      }
    }
    return false;
  }

  private boolean isInExtent() {
    return cell[0] >= low[0]
        && cell[0] <= high[0]
        && cell[1] >= low[1]
        && cell[1] <= high[1]
        && cell[2] >= low[2]
        && cell[2] <= high[2];
  }

  /** Whether the line, projected along the third axis, has the whole voxel on one side. */
  private boolean isApart(int u, int v) {
    int first = side(u, v, 0, 0);
    return first != 0
        && first == side(u, v, 1, 0)
        && first == side(u, v, 0, 1)
        && first == side(u, v, 1, 1);
  }

  /** Returns the side of the line on which a corner lies: the sign of a cross product. */
  private int side(int u, int v, int cornerU, int cornerV) {
    double a = (to[u] - from[u]) * (cell[v] + cornerV - from[v]);
    double b = (to[v] - from[v]) * (cell[u] + cornerU - from[u]);
    double difference = a - b;
    double error = (Math.abs(a) + Math.abs(b)) * RELATIVE_ERROR + MIN_RELIABLE;
    if (filtered && Math.abs(difference) > error && error < Double.POSITIVE_INFINITY) {
      return difference > 0 ? 1 : -1;
    }
    return exactSide(u, v, cornerU, cornerV);
  }

  private int exactSide(int u, int v, int cornerU, int cornerV) {
    exactDecisions++;
    BigDecimal fromU = new BigDecimal(from[u]);
    BigDecimal fromV = new BigDecimal(from[v]);
    BigDecimal alongU = new BigDecimal(to[u]).subtract(fromU);
    BigDecimal alongV = new BigDecimal(to[v]).subtract(fromV);
    BigDecimal toU = BigDecimal.valueOf((long) cell[u] + cornerU).subtract(fromU);
    BigDecimal toV = BigDecimal.valueOf((long) cell[v] + cornerV).subtract(fromV);
    return alongU.multiply(toV).compareTo(alongV.multiply(toU));
  }
}
