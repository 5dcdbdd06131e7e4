package org.palpate.io.format;

/**
 * An axis that is not of space (time, components), of which one step is read.
 *
 * @param position how many axes of space vary faster than it, 0 to 3
 * @param count steps along it, at least 1
 * @param chosen the step that is read, from 0
 */
public record NonSpatialAxis(int position, int count, int chosen) {
  public static final NonSpatialAxis NONE = new NonSpatialAxis(3, 1, 0);

  /** Samples that lie together inside one step, in a slice of the given sizes. */
  int contiguousSamples(int sizeX, int sizeY) {
    return switch (position) {
      case 0 -> 1;
      case 1 -> sizeX;
      default -> sizeX * sizeY;
    };
  }
}
