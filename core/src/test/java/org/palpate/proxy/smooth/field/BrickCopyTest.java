package org.palpate.proxy.smooth.field;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

class BrickCopyTest {
  private final CollisionScene scene = new CollisionScene(List.of(new BitCube(8, 8, 8)));

  @Test
  void movedBricksKeepTheirPlaces() {
    for (int n = 0; n < 7 * 7 * 7; n++) {
      int x = n % 7 - 3;
      int y = n / 7 % 7 - 3;
      int z = n / 49 - 3;
      long expected = 0;
      long bricks = 0x9E37_79B9_7F4A_7C15L * (n + 1);
      for (int to = 0; to < Long.SIZE; to++) {
        int fromX = (to & 3) + x;
        int fromY = (to >> 2 & 3) + y;
        int fromZ = (to >> 4) + z;
        boolean inBoth = (fromX & 3) == fromX && (fromY & 3) == fromY && (fromZ & 3) == fromZ;
        if (inBoth && (bricks >>> BrickCopy.number(fromX, fromY, fromZ) & 1) != 0) {
          expected |= 1L << to;
        }
      }
      assertEquals(expected, BrickCopy.moved(bricks, x, y, z), x + "," + y + "," + z);
    }
    assertEquals(0, BrickCopy.moved(-1, 4, 0, 0));
    assertEquals(0, BrickCopy.moved(-1, 0, -1_000_000_000, 0));
  }

  @Test
  void aCopyAheadIsMadeOnceAndOnlyWhatIsNewWhenItMoves() {
    Bricks bricks = new Bricks();
    BrickCopy.Ahead ahead = new BrickCopy.Ahead(bricks);
    makeAll(ahead, 10, 30);
    assertEquals(64, bricks.made.size());
    assertEquals(64, bricks.calls);
    makeAll(ahead, 14, 30);
    assertEquals(80, bricks.made.size());
    assertEquals(80, bricks.calls);
    makeAll(ahead, 10, 26);
    // The layer of bricks along x was there before, but is not remembered.
    assertEquals(80 + 28, bricks.calls);
    ahead.forget();
    makeAll(ahead, 10, 26);
    assertEquals(80 + 28 + 64, bricks.calls);
  }

  private void makeAll(BrickCopy.Ahead ahead, int x, int y) {
    for (int frame = 0; frame < 10; frame++) {
      ahead.make(scene, x, y, 20);
    }
  }

  /** Counts the bricks that are asked for. */
  private static final class Bricks implements BrickSource {
    private final Set<List<Integer>> made = new HashSet<>();
    private int calls;

    @Override
    public long brick(CollisionScene scene, int x, int y, int z) {
      made.add(List.of(x, y, z));
      calls++;
      return 0;
    }

    @Override
    public void forget() {}

    @Override
    public void forget(IntBox changed) {}
  }
}
