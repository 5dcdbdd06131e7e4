package org.palpate.elastic;

import java.util.concurrent.atomic.AtomicLongArray;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.LatticeLayout;
import org.palpate.geometry.IntBox;

/**
 * The cells whose voxels an edit may have changed. The haptic thread marks them; the thread of the
 * updates counts their voxels anew. Neither waits, and nothing is allocated.
 */
final class ChangedCells {
  private final ControlLattice lattice;
  private final AtomicLongArray marks;

  ChangedCells(ControlLattice lattice) {
    this.lattice = lattice;
    marks = new AtomicLongArray((lattice.editedCells() + Long.SIZE - 1) / Long.SIZE);
  }

  /** Marks the cells of a box of voxels, which may be empty. Haptic thread, after the writes. */
  void mark(IntBox voxels) {
    if (voxels.isEmpty()) {
      return;
    }
    LatticeLayout layout = lattice.layout();
    for (int k = voxels.lowZ; k <= voxels.highZ; k = next(layout, 2, k, voxels.highZ)) {
      for (int j = voxels.lowY; j <= voxels.highY; j = next(layout, 1, j, voxels.highY)) {
        for (int i = voxels.lowX; i <= voxels.highX; i = next(layout, 0, i, voxels.highX)) {
          mark(lattice.editedCell(i, j, k));
        }
      }
    }
  }

  /** Returns the first voxel of the next cell, or the end of the box if that comes first. */
  private static int next(LatticeLayout layout, int axis, int voxel, int high) {
    int into = Math.floorMod(voxel - layout.originVoxel(axis), layout.voxelsPerCell(axis));
    return voxel == high ? high + 1 : Math.min(high, voxel - into + layout.voxelsPerCell(axis));
  }

  private void mark(int cell) {
    if (cell < 0) {
      return;
    }
    // A mark that is set already is set again, so that the reader sees the voxels of this edit too.
    marks.accumulateAndGet(cell / Long.SIZE, 1L << cell, (before, bit) -> before | bit);
  }

  /** Counts the voxels of the marked cells anew. Thread of the updates. */
  void refill(UpdateListener listener) {
    for (int word = 0; word < marks.length(); word++) {
      long rest = marks.get(word) == 0 ? 0 : marks.getAndSet(word, 0);
      for (; rest != 0; rest &= rest - 1) {
        int cell = word * Long.SIZE + Long.numberOfTrailingZeros(rest);
        if (listener == UpdateListener.NONE) {
          lattice.refill(cell);
        } else {
          lattice.refill(cell, listener::refilled);
        }
      }
    }
  }
}
