package org.palpate.proxy;

/**
 * The path of the interaction point in one frame: straight legs in the order of travel, with their
 * lengths.
 *
 * <p>Invariant: each leg starts bit for bit where the one before ended, and the first starts where
 * the last frame ended. The solver that adds the legs keeps it; this class does not check it.
 *
 * <p>Coordinates are grid coordinates; lengths are metric, in millimetres. The capacity is fixed: a
 * solver ends its frame when the path {@link #isFull}. Haptic thread; allocates nothing after
 * construction; all methods take constant time.
 */
public final class LegPath {
  /** The largest number of legs in one frame. */
  public static final int CAPACITY = 256;

  private static final int DOUBLES_PER_LEG = 6;

  private final double[] ends = new double[CAPACITY * DOUBLES_PER_LEG];
  private final boolean[] slid = new boolean[CAPACITY];
  private final double[] lengthsMm = new double[CAPACITY];
  private int count;
  private double lengthMm;

  /** Removes all legs. */
  public void clear() {
    truncate(0, 0);
  }

  /**
   * Removes the last legs.
   *
   * @param newCount the number of legs that stay
   * @param newLengthMm the length of the legs that stay, as {@link #lengthMm()} returned it
   */
  public void truncate(int newCount, double newLengthMm) {
    count = newCount;
    lengthMm = newLengthMm;
  }

  /** {@return whether there is no room for another leg} */
  public boolean isFull() {
    return count == CAPACITY;
  }

  /** {@return the number of legs} */
  public int count() {
    return count;
  }

  /** {@return the length of all legs together, mm} */
  public double lengthMm() {
    return lengthMm;
  }

  /**
   * Adds a leg.
   *
   * @param x0 the start of the leg along x, grid coordinates
   * @param y0 its y component
   * @param z0 its z component
   * @param x1 the end of the leg along x, grid coordinates
   * @param y1 its y component
   * @param z1 its z component
   * @param legLengthMm the metric length of the leg, mm
   * @param alongSurface whether the leg slides along a surface, which friction depends on
   * @throws ArrayIndexOutOfBoundsException if the path {@link #isFull}
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
    int at = count * DOUBLES_PER_LEG;
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

  /**
   * {@return the start of a leg along an axis, grid coordinates}
   *
   * @param leg the number of the leg, from 0
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double start(int leg, int axis) {
    return ends[leg * DOUBLES_PER_LEG + axis];
  }

  /**
   * {@return the end of a leg along an axis, grid coordinates}
   *
   * @param leg the number of the leg, from 0
   * @param axis 0 for x, 1 for y, 2 for z
   */
  public double end(int leg, int axis) {
    return ends[leg * DOUBLES_PER_LEG + 3 + axis];
  }

  /**
   * {@return the metric length of a leg, mm}
   *
   * @param leg the number of the leg, from 0
   */
  public double lengthMm(int leg) {
    return lengthsMm[leg];
  }

  /**
   * {@return whether a leg slid along a surface}
   *
   * @param leg the number of the leg, from 0
   */
  public boolean slid(int leg) {
    return slid[leg];
  }
}
