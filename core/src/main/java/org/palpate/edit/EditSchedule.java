package org.palpate.edit;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;

/** The changes of voxels of a recorded session, frame by frame. One thread. */
public final class EditSchedule {
  /** A schedule without changes. */
  public static final EditSchedule NONE = new EditSchedule(List.of());

  private final List<VoxelChange> changes;
  private int next;

  /**
   * Makes a schedule.
   *
   * @param changes in any order of their frames; those of one frame keep their order
   */
  public EditSchedule(List<VoxelChange> changes) {
    List<VoxelChange> sorted = new ArrayList<>(changes);
    sorted.sort(Comparator.comparingLong(VoxelChange::frame));
    this.changes = sorted;
  }

  /** {@return all changes, in the order of their frames} */
  public List<VoxelChange> changes() {
    return Collections.unmodifiableList(changes);
  }

  /**
   * Queues the changes up to a frame that were not queued yet, as one edit.
   *
   * @param frame the last frame whose changes are queued, from 0
   * @param queue receives the edit
   * @throws IllegalStateException if the queue has no room
   */
  public void offerUpTo(long frame, EditQueue queue) {
    int end = next;
    while (end < changes.size() && changes.get(end).frame() <= frame) {
      end++;
    }
    if (end > next && !queue.offer(new VoxelListEdit(changes.subList(next, end)))) {
      throw new IllegalStateException("the queue of edits is full: frame=" + frame);
    }
    next = end;
  }
}
