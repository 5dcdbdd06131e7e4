package org.palpate.proxy;

/**
 * The legs of one frame, in the order in which the interaction point travelled them, and their
 * lengths.
 *
 * <p>Each leg starts bit for bit where the one before ended; the first starts where the last frame
 * ended. Of fixed capacity: a solver stops for the frame when it is full.
 */
public final class LegPath {
  /** The most legs of one frame. */
  public static final int CAPACITY = 256;

  private static final int DOUBLES_A_LEG = 6;

  private final double[] ends = new double[CAPACITY * DOUBLES_A_LEG];
  private final boolean[] slid = new boolean[CAPACITY];
  private final double[] lengthsMm = new double[CAPACITY];
  private int count;
  private double lengthMm;

  /** Forgets all legs. */
  public void clear() {
    truncate(0, 0);
  }

  /**
   * Forgets the legs from {@code newCount} on; {@code newLengthMm} is the path's length before
   * them.
   */
  public void truncate(int newCount, double newLengthMm) {
    count = newCount;
    lengthMm = newLengthMm;
  }

  public boolean isFull() {
    return count == CAPACITY;
  }

  public int count() {
    return count;
  }

  /** The length of all legs together, mm. */
  public double lengthMm() {
    return lengthMm;
  }

  /**
   * Adds a leg.
   *
   * @param legLengthMm its metric length
   * @param alongSurface whether it slid along a surface, which friction wants to know
   */
  public void add(
      double x0,
      double y0,
      double z0,
      double x1,
      double y1,
      double z1,
      double legLengthMm,
      boolean alongSurface) {
    int at = count * DOUBLES_A_LEG;
    ends[at] = x0;
    ends[at + 1] = y0;
    ends[at + 2] = z0;
    ends[at + 3] = x1;
    ends[at + 4] = y1;
    ends[at + 5] = z1;
    slid[count] = alongSurface;
    lengthsMm[count] = legLengthMm;
    count++;
    lengthMm += legLengthMm;
  }

  /** Start of a leg along an axis, grid coordinates. */
  public double start(int leg, int axis) {
    return ends[leg * DOUBLES_A_LEG + axis];
  }

  /** End of a leg along an axis, grid coordinates. */
  public double end(int leg, int axis) {
    return ends[leg * DOUBLES_A_LEG + 3 + axis];
  }

  /** Metric length of a leg, mm. */
  public double lengthMm(int leg) {
    return lengthsMm[leg];
  }

  /** Whether a leg slid along a surface. */
  public boolean slid(int leg) {
    return slid[leg];
  }
}
