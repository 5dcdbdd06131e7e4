package org.palpate.volume.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.VoxelGrid;

class FragmentCutterTest {
  private static final long RECORDED = 1928910847922889164L;

  private static final VoxelGrid GRID =
      new VoxelGrid(40, 36, 50, new Vec3(0.7, 0.7, 1.4), RigidTransform.identity());

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void leavesTheKerfBetweenAnyTwoFragmentsAndNoMore(int kerf) {
    for (int parts = 2; parts <= 8; parts++) {
      Fragments fragments = FragmentCutter.cut(tube(), GRID, new FractureSpec(parts, 11, kerf));
      int least = Integer.MAX_VALUE;
      for (int a = 0; a < parts; a++) {
        for (int b = 0; b < a; b++) {
          least =
              Math.min(least, emptyVoxelsBetween(fragments.bits().get(a), fragments.bits().get(b)));
        }
      }
      assertEquals(kerf, least, parts + " parts");
    }
  }

  /** Returns the fewest empty voxels along the longest axis from any voxel to any other. */
  private static int emptyVoxelsBetween(BitCube a, BitCube b) {
    List<int[]> ofB = voxels(b);
    int least = Integer.MAX_VALUE;
    for (int[] v : voxels(a)) {
      for (int[] w : ofB) {
        int steps = Math.abs(v[0] - w[0]);
        steps = Math.max(steps, Math.abs(v[1] - w[1]));
        steps = Math.max(steps, Math.abs(v[2] - w[2]));
        least = Math.min(least, steps - 1);
      }
    }
    return least;
  }

  @Test
  void fragmentsAreWholePiecesOfTheBoneAndShareNoVoxel() {
    BitCube bone = tube();
    for (int seed = 1; seed <= 5; seed++) {
      Fragments fragments = FragmentCutter.cut(bone, GRID, new FractureSpec(6, seed, 1));
      long kept = 0;
      for (int[] v : voxels(bone)) {
        int owners = 0;
        for (BitCube part : fragments.bits()) {
          owners += part.get(v[0], v[1], v[2]) ? 1 : 0;
        }
        assertTrue(owners <= 1);
        kept += owners;
      }
      long all = 0;
      for (BitCube part : fragments.bits()) {
        assertEquals(1, ConnectedComponents.of(part, Neighbours.FACES_EDGES_CORNERS, 1).size());
        all += part.solidCount();
      }
      assertEquals(all, kept, "a fragment has a voxel that the bone has not");
      assertEquals(bone.solidCount() - kept, fragments.lostVoxels());
    }
  }

  @Test
  void withoutAKerfEveryVoxelOfTheBoneIsInAFragment() {
    assertEquals(0, FragmentCutter.cut(tube(), GRID, new FractureSpec(8, 3, 0)).lostVoxels());
  }

  @Test
  void leavesOutWhatIsNotConnectedToTheBone() {
    BitCube bone = tube();
    long connected = bone.solidCount();
    bone.set(0, 0, 0);
    Fragments fragments = FragmentCutter.cut(bone, GRID, new FractureSpec(2, 3, 0));
    assertEquals(1, fragments.lostVoxels());
    assertEquals(connected, fragments.bits().stream().mapToLong(BitCube::solidCount).sum());
  }

  @Test
  void theLargestFragmentComesFirstAndNoneIsTiny() {
    for (int seed = 1; seed <= 10; seed++) {
      List<BitCube> parts = FragmentCutter.cut(tube(), GRID, new FractureSpec(4, seed, 1)).bits();
      for (BitCube part : parts) {
        assertTrue(part.solidCount() <= parts.get(0).solidCount());
        assertTrue(part.solidCount() > tube().solidCount() / 20);
      }
    }
  }

  @Test
  void differentSeedsCutDifferently() {
    BitCube one = FragmentCutter.cut(tube(), GRID, new FractureSpec(3, 1, 0)).bits().get(0);
    BitCube other = FragmentCutter.cut(tube(), GRID, new FractureSpec(3, 2, 0)).bits().get(0);
    assertFalse(checksum(one) == checksum(other));
  }

  /** The number was recorded; it holds on every JDK and machine. */
  @Test
  void cutsTheSameVoxelsEverywhere() {
    Fragments fragments = FragmentCutter.cut(tube(), GRID, new FractureSpec(4, 7, 1));
    long sum = 0;
    for (BitCube part : fragments.bits()) {
      sum = 31 * sum + checksum(part);
    }
    assertEquals(RECORDED, sum);
  }

  @Test
  void refusesABoneThatIsTooSmall() {
    BitCube small = new BitCube(10, 10, 10);
    small.set(5, 5, 5);
    String message =
        assertThrows(
                IllegalArgumentException.class,
                () ->
                    FragmentCutter.cut(
                        small, VoxelGrid.ofUnitVoxels(10, 10, 10), new FractureSpec(2, 1, 0)))
            .getMessage();
    assertTrue(message.contains("too small") && message.contains("1 voxels"), message);
  }

  @Test
  void aSpecificationIsReadAsItIsWritten() {
    assertEquals(new FractureSpec(4, 1, 1), FractureSpec.parse("4"));
    assertEquals(new FractureSpec(4, 77, 1), FractureSpec.parse("4:77"));
    assertEquals(new FractureSpec(4, 77, 0), FractureSpec.parse("4:77:0"));
    for (String wrong : List.of("", "x", "1", "9", "4:", "4:1:5", "4:1:1:1", "-4", "4:-1", "4.5")) {
      assertThrows(IllegalArgumentException.class, () -> FractureSpec.parse(wrong), wrong);
    }
  }

  private static long checksum(BitCube bits) {
    long sum = 17;
    for (int[] v : voxels(bits)) {
      sum = sum * 1_000_003 + v[0] + 1000L * v[1] + 1_000_000L * v[2];
    }
    return sum;
  }

  /** Returns a hollow tube that bends, with a wall of three voxels. */
  private static BitCube tube() {
    BitCube bits = new BitCube(GRID.sizeX(), GRID.sizeY(), GRID.sizeZ());
    for (int k = 3; k < 47; k++) {
      for (int j = 0; j < 36; j++) {
        for (int i = 0; i < 40; i++) {
          double x = i + 0.5 - 20 - k * (50 - k) / 150.0;
          double y = j + 0.5 - 18;
          double r = Math.sqrt(x * x + y * y);
          if (r < 10 && r > 7) {
            bits.set(i, j, k);
          }
        }
      }
    }
    return bits;
  }

  private static List<int[]> voxels(BitCube bits) {
    List<int[]> found = new ArrayList<>();
    for (int k = 0; k < bits.sizeZ(); k++) {
      for (int j = 0; j < bits.sizeY(); j++) {
        for (int i = 0; i < bits.sizeX(); i++) {
          if (bits.get(i, j, k)) {
            found.add(new int[] {i, j, k});
          }
        }
      }
    }
    return found;
  }
}
