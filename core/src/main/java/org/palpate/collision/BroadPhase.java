package org.palpate.collision;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Of many cubes those whose solids may lie where the interaction point is: found by a tree, with a
 * margin, and kept until a question leaves it. Haptic thread only; asking allocates nothing.
 *
 * <p>Cubes that were handed out, and so may be edited, are always among them, since their bounds
 * may have grown.
 */
final class BroadPhase {
  /** What a point crosses in some frames. */
  private static final int MARGIN_VOXELS = 16;

  private final BitCube[] cubes;
  private final BoundingVolumeTree tree;
  private final boolean[] loose;
  private final int[] numbers;
  private final BitCube[] near;
  private final IntBox covered = new IntBox();
  private final IntBox asked = new IntBox();
  private int looseCount;
  private int count;
  private long searches;
  private long skipped;

  /** Takes the cubes' bounds as they are now. */
  BroadPhase(BitCube[] cubes) {
    this.cubes = cubes;
    IntBox[] boxes = new IntBox[cubes.length];
    Arrays.setAll(boxes, n -> new IntBox().set(cubes[n].bounds()));
    tree = new BoundingVolumeTree(boxes);
    loose = new boolean[cubes.length];
    numbers = new int[cubes.length];
    near = new BitCube[cubes.length];
  }

  /** The same cubes by their bounds as they are now, those that were handed out among them. */
  BroadPhase anew() {
    BroadPhase fresh = new BroadPhase(cubes);
    System.arraycopy(loose, 0, fresh.loose, 0, loose.length);
    fresh.looseCount = looseCount;
    fresh.searches = searches;
    fresh.skipped = skipped;
    return fresh;
  }

  /** From now on the cube is always among the near ones. */
  void loosen(int number) {
    if (!loose[number]) {
      loose[number] = true;
      looseCount++;
    }
    covered.clear();
  }

  /** How many cubes may have solids in a box of voxels; {@link #cube} gives them. */
  int find(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    if (!covered.contains(lowX, lowY, lowZ) || !covered.contains(highX, highY, highZ)) {
      asked.clear();
      asked.include(lowX, lowY, lowZ);
      asked.include(highX, highY, highZ);
      search();
    }
    skipped += cubes.length - count;
    return count;
  }

  /** One of the near cubes, in the order of all cubes. */
  BitCube cube(int number) {
    return near[number];
  }

  /** The place of one of the near cubes among all. */
  int place(int number) {
    return numbers[number];
  }

  /** How often a question left what was known. */
  long searches() {
    return searches;
  }

  /** How many cubes were not looked at, over all questions. */
  long skipped() {
    return skipped;
  }

  private void search() {
    searches++;
    covered.set(asked).grow(MARGIN_VOXELS);
    count = tree.find(covered, numbers);
    if (looseCount > 0) {
      addLoose();
    }
    // In the order of all cubes, so that the first of equal hits is the same.
    Arrays.sort(numbers, 0, count);
    for (int n = 0; n < count; n++) {
      near[n] = cubes[numbers[n]];
    }
  }

  private void addLoose() {
    int kept = 0;
    for (int n = 0; n < count; n++) {
      if (!loose[numbers[n]]) {
        numbers[kept++] = numbers[n];
      }
    }
    for (int number = 0; number < cubes.length; number++) {
      if (loose[number]) {
        numbers[kept++] = number;
      }
    }
    count = kept;
  }
}
