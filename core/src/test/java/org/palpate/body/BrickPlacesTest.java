package org.palpate.body;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.volume.BitCube;

class BrickPlacesTest {
  /** 10 x 6 x 4 bricks. */
  private final BitCube bits = new BitCube(40, 24, 16);

  @Test
  void eachBrickHasItsOwnIndexAndAPlaceOfTheCache() {
    BrickPlaces places = new BrickPlaces(bits, 3, 14);
    Set<Long> indices = new HashSet<>();
    Set<Integer> used = new HashSet<>();
    for (int z = 0; z < 4; z++) {
      for (int y = 0; y < 6; y++) {
        for (int x = 0; x < 10; x++) {
          assertTrue(places.contain(x, y, z));
          long index = places.index(x, y, z);
          indices.add(index);
          int place = places.place(index);
          assertTrue(place >= 0 && place < places.count());
          used.add(place);
        }
      }
    }
    assertEquals(240, indices.size());
    assertEquals(32, places.count(), "the power of two above 240 / 8");
    assertEquals(32, used.size(), "no place stays unused");
  }

  @Test
  void bricksBeyondTheCubeAreNotContained() {
    BrickPlaces places = new BrickPlaces(bits, 3, 14);
    int[][] beyond = {{-1, 0, 0}, {10, 0, 0}, {0, -1, 0}, {0, 6, 0}, {0, 0, -1}, {0, 0, 4}};
    for (int[] brick : beyond) {
      assertFalse(places.contain(brick[0], brick[1], brick[2]));
    }
  }

  @Test
  void aCacheHasAtMostTheGivenPlaces() {
    assertEquals(4, new BrickPlaces(bits, 0, 2).count());
  }

  @Test
  void anEmptyPlaceBelongsToNoBrickAndForgettingChangesAllNumbers() {
    BrickPlaces places = new BrickPlaces(bits, 3, 14);
    long before = places.number(0);
    assertNotEquals(0, before);
    assertFalse(places.forget());
    assertNotEquals(before, places.number(0));
  }

  @Test
  void afterAllAgesTheCallerIsToldToClearItsPlaces() {
    BrickPlaces places = new BrickPlaces(bits, 3, 14);
    long first = places.number(7);
    long ages = 1;
    while (!places.forget()) {
      ages++;
    }
    assertEquals((1L << Integer.SIZE) - 1, ages);
    assertEquals(first, places.number(7), "the numbers begin anew");
  }
}
