package org.palpate.benchmarks.hold;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

class UndersideTest {
  @Test
  void aFlatPlaceIsTheOneNearestToTheMiddle() {
    BitCube block = block(4, 20, 10, 15);
    Vec3 place = new Underside(List.of(block), 0).flatPlace().orElseThrow();
    assertEquals(new Vec3(12.5, 12.5, 10).toString(), place.toString());
  }

  @Test
  void aPlaceOverAnotherFragmentIsNotSeen() {
    BitCube block = block(4, 20, 10, 15);
    BitCube below = block(4, 14, 3, 5);
    Vec3 place = new Underside(List.of(below, block), 1).flatPlace().orElseThrow();
    // Columns up to 14 are hidden, and a flat place has two free columns beside it.
    assertEquals(new Vec3(17.5, 12.5, 10).toString(), place.toString());
  }

  @Test
  void aFragmentThatOthersCoverHasNoPlace() {
    BitCube block = block(4, 20, 10, 15);
    BitCube below = block(3, 21, 3, 5);
    assertEquals(Optional.empty(), new Underside(List.of(block, below), 0).flatPlace());
  }

  @Test
  void aFragmentThatIsThinnerThanAFlatPlaceHasNone() {
    assertEquals(Optional.empty(), new Underside(List.of(block(4, 7, 10, 15)), 0).flatPlace());
  }

  /** Returns a block with columns {@code lowX} to {@code highX}, rows 4 to 20, in some layers. */
  private static BitCube block(int lowX, int highX, int lowZ, int highZ) {
    BitCube cube = new BitCube(24, 24, 24);
    for (int k = lowZ; k <= highZ; k++) {
      for (int j = 4; j <= 20; j++) {
        for (int i = lowX; i <= highX; i++) {
          cube.set(i, j, k);
        }
      }
    }
    return cube;
  }
}
