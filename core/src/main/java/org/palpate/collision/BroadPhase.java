package org.palpate.collision;

import java.util.Arrays;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Finds the candidates of a query: the few cubes, out of many, whose solids may lie near the
 * interaction point. A bounding-volume tree finds them within a margin. They stay valid until a
 * query leaves the margin.
 *
 * <p>A cube that was handed out for editing is always a candidate, because its bounds may grow.
 * Haptic thread only; a query allocates nothing.
 */
final class BroadPhase {
  /** The distance that a point travels in a few frames. */
  private static final int MARGIN_VOXELS = 16;

  private final BitCube[] cubes;
  private final BoundingVolumeTree tree;
  private final boolean[] alwaysCandidate;
  private final int[] indices;
  private final BitCube[] candidates;
  private final IntBox covered = new IntBox();
  private final IntBox query = new IntBox();
  private int alwaysCount;
  private int count;
  private long searches;
  private long skippedCubes;

  /**
   * Creates a broad phase from the present bounds of the cubes.
   *
   * @param cubes the scene's own array; a replaced cube must be reported by {@link #keep}
   */
  BroadPhase(BitCube[] cubes) {
    this.cubes = cubes;
    IntBox[] boxes = new IntBox[cubes.length];
    Arrays.setAll(boxes, n -> new IntBox().set(cubes[n].bounds()));
    tree = new BoundingVolumeTree(boxes);
    alwaysCandidate = new boolean[cubes.length];
    indices = new int[cubes.length];
    candidates = new BitCube[cubes.length];
  }

  /**
   * Returns a broad phase built from the present bounds. It takes over the counters and the cubes
   * that {@link #keep} was called for.
   */
  BroadPhase rebuilt() {
    BroadPhase fresh = new BroadPhase(cubes);
    System.arraycopy(alwaysCandidate, 0, fresh.alwaysCandidate, 0, alwaysCandidate.length);
    fresh.alwaysCount = alwaysCount;
    fresh.searches = searches;
    fresh.skippedCubes = skippedCubes;
    return fresh;
  }

  /** Makes a cube a candidate of every query from now on. */
  void keep(int index) {
    if (!alwaysCandidate[index]) {
      alwaysCandidate[index] = true;
      alwaysCount++;
    }
    covered.clear();
  }

  /**
   * Finds the cubes that may have solids in a box of voxels, both ends included.
   *
   * @return the number of candidates, which are the first elements of {@link #candidates}
   */
  int find(int lowX, int lowY, int lowZ, int highX, int highY, int highZ) {
    if (!covered.contains(lowX, lowY, lowZ) || !covered.contains(highX, highY, highZ)) {
      query.clear();
      query.include(lowX, lowY, lowZ);
      query.include(highX, highY, highZ);
      search();
    }
    skippedCubes += cubes.length - count;
    return count;
  }

  /** Returns the candidates in the order of the scene; always the same array. */
  BitCube[] candidates() {
    return candidates;
  }

  /** Returns the index in the scene of a candidate. */
  int index(int candidate) {
    return indices[candidate];
  }

  /** Returns the number of queries that had to search the tree. */
  long searches() {
    return searches;
  }

  /** Returns the number of cubes that were left out, summed over all queries. */
  long skippedCubes() {
    return skippedCubes;
  }

  private void search() {
    searches++;
    covered.set(query).grow(MARGIN_VOXELS);
    count = tree.find(covered, indices);
    if (alwaysCount > 0) {
      addKept();
    }
    // In the order of the scene, so that the choice among equal hits does not depend on the search.
    Arrays.sort(indices, 0, count);
    for (int n = 0; n < count; n++) {
      candidates[n] = cubes[indices[n]];
    }
  }

  private void addKept() {
    int found = 0;
    for (int n = 0; n < count; n++) {
      if (!alwaysCandidate[indices[n]]) {
        indices[found++] = indices[n];
      }
    }
    for (int index = 0; index < cubes.length; index++) {
      if (alwaysCandidate[index]) {
        indices[found++] = index;
      }
    }
    count = found;
  }
}
