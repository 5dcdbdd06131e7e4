package org.palpate.io.format;

/**
 * An axis of time or components, of which one step is read.
 *
 * @param position how many spatial axes vary faster, 0 to 3
 * @param count steps along the axis, at least 1
 * @param chosen the step to read, from 0
 */
public record NonSpatialAxis(int position, int count, int chosen) {
  public static final NonSpatialAxis NONE = new NonSpatialAxis(3, 1, 0);

  /** Returns how many samples of one step are contiguous in a slice of the given size. */
  public int contiguousSamples(int sizeX, int sizeY) {
    return switch (position) {
      case 0 -> 1;
      case 1 -> sizeX;
      default -> sizeX * sizeY;
    };
  }
}
