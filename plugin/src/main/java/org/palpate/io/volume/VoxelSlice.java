package org.palpate.io.volume;

/**
 * The values of one slice, x fastest, as the file means them: whole numbers where the file can only
 * hold such ({@link #isInteger}), doubles otherwise. The reader fills it again and again; whoever
 * is handed one must not keep it.
 */
public final class VoxelSlice {
  private final int sizeX;
  private final int sizeY;
  private final int[] integers;
  private final double[] doubles;

  /** A slice of zeros, of whole numbers or of doubles for all its life. */
  public VoxelSlice(int sizeX, int sizeY, boolean integer) {
    this.sizeX = sizeX;
    this.sizeY = sizeY;
    int count = Math.multiplyExact(sizeX, sizeY);
    integers = integer ? new int[count] : new int[0];
    doubles = integer ? new double[0] : new double[count];
  }

  public int sizeX() {
    return sizeX;
  }

  public int sizeY() {
    return sizeY;
  }

  public int count() {
    return sizeX * sizeY;
  }

  /** Whether {@link #integers} holds the values; {@link #doubles} does otherwise. */
  public boolean isInteger() {
    return integers.length > 0;
  }

  /** The values where {@link #isInteger}, else empty. */
  public int[] integers() {
    return integers;
  }

  /** The values where not {@link #isInteger}, else empty. */
  public double[] doubles() {
    return doubles;
  }

  /** The value at an index, {@code j * sizeX + i}. */
  public double value(int index) {
    return isInteger() ? integers[index] : doubles[index];
  }
}
