package org.palpate.io.volume;

/**
 * The values of one slice, x fastest, after slope and intercept. They are integers if the file can
 * only hold integers ({@link #isInteger}), else doubles. A reader reuses its slice, so a receiver
 * must not keep it.
 */
public final class VoxelSlice {
  private final int sizeX;
  private final int sizeY;
  private final int[] integers;
  private final double[] doubles;

  /** Creates a slice of zeros that holds integers or doubles for all its life. */
  public VoxelSlice(int sizeX, int sizeY, boolean integer) {
    this.sizeX = sizeX;
    this.sizeY = sizeY;
    int count = Math.multiplyExact(sizeX, sizeY);
    integers = integer ? new int[count] : new int[0];
    doubles = integer ? new double[0] : new double[count];
  }

  /** Returns the number of voxels along x. */
  public int sizeX() {
    return sizeX;
  }

  /** Returns the number of voxels along y. */
  public int sizeY() {
    return sizeY;
  }

  /** Returns the number of voxels. */
  public int count() {
    return sizeX * sizeY;
  }

  /** Whether {@link #integers} holds the values; otherwise {@link #doubles} does. */
  public boolean isInteger() {
    return integers.length > 0;
  }

  /** Returns the values if {@link #isInteger}, else an empty array. */
  public int[] integers() {
    return integers;
  }

  /** Returns the values if not {@link #isInteger}, else an empty array. */
  public double[] doubles() {
    return doubles;
  }

  /** Returns the value at index {@code j * sizeX + i}. */
  public double value(int index) {
    return isInteger() ? integers[index] : doubles[index];
  }
}
