package org.palpate.body;

import org.palpate.volume.BitCube;

/**
 * Spreads the bricks of a bit cube over the places of a cache. Bricks may share a place, so a place
 * keeps the number of the brick to which its content belongs.
 *
 * <p>A number consists of an age and of the brick. {@link #forget} raises the age, which makes the
 * content of all places old without touching them. Haptic thread only; allocates nothing.
 */
final class BrickPlaces {
  /** 2^64 divided by the golden ratio. Its multiples are spread evenly over the places. */
  private static final long SPREAD = 0x9E37_79B9_7F4A_7C15L;

  private final int bricksX;
  private final int bricksY;
  private final int bricksZ;
  private final int placesShift;

  /** Counts how often all was forgotten, from 1 to 2^32 - 1; the upper half of a number. */
  private long age = 1;

  /**
   * Creates the places of a cache.
   *
   * @param bits the bit cube
   * @param bricksPerPlaceShift the binary logarithm of about how many bricks share a place, in
   *     cubes that are not large
   * @param mostPlacesShift the binary logarithm of the most places
   */
  BrickPlaces(BitCube bits, int bricksPerPlaceShift, int mostPlacesShift) {
    bricksX = bits.bricksX();
    bricksY = bits.bricksY();
    bricksZ = bits.bricksZ();
    long places = ((long) bricksX * bricksY * bricksZ) >> bricksPerPlaceShift;
    placesShift = Math.min(mostPlacesShift, Long.SIZE - Long.numberOfLeadingZeros(places | 1));
  }

  /** Returns the number of places. */
  int count() {
    return 1 << placesShift;
  }

  /** Whether a brick belongs to the bit cube. */
  boolean contain(int x, int y, int z) {
    return x >= 0 && x < bricksX && y >= 0 && y < bricksY && z >= 0 && z < bricksZ;
  }

  /** Returns the index of a brick of the bit cube. */
  long index(int x, int y, int z) {
    return ((long) z * bricksY + y) * bricksX + x;
  }

  /** Returns the number that the place of a brick has as long as its content is not forgotten. */
  long number(long index) {
    return age << Integer.SIZE | index;
  }

  /** Returns the place of a brick, from 0. */
  int place(long index) {
    return (int) ((index * SPREAD) >>> (Long.SIZE - placesShift));
  }

  /**
   * Forgets the content of all places.
   *
   * @return whether the ages begin anew, so that the caller must set the numbers of all places to 0
   */
  boolean forget() {
    age++;
    if ((int) age != 0) {
      return false;
    }
    age = 1;
    return true;
  }
}
