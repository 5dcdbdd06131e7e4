package org.palpate.edit;

import java.util.Arrays;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.IntBox;
import org.palpate.volume.BitCube;

/**
 * Changes the voxels of a scene for edits, for cutting and for undo. It notes each change in the
 * {@link UndoHistory} and reports it to listeners. Nothing else changes voxels during a session.
 *
 * <p>Haptic thread only; a change allocates nothing.
 */
public final class VoxelWriter {
  /** The usual number of changed bricks that can be undone, which take 2 MiB. */
  public static final int DEFAULT_CAPACITY = 1 << 16;

  private final CollisionScene scene;
  private final EditListener boxes;
  private final VoxelLog log;
  private final UndoHistory history;
  private final IntBox box = new IntBox();
  private final IntBox changed = new IntBox();
  private boolean greyChanged;
  private BitCube[] limits = {};
  private VoxelListener voxels = VoxelListener.NONE;
  private ToolPlace tool = ToolPlace.NONE;

  /**
   * Creates a writer with a history of the usual capacity.
   *
   * @param scene the voxels to change
   * @param boxes receives a box around the voxels of each edit
   */
  public VoxelWriter(CollisionScene scene, EditListener boxes) {
    this(scene, boxes, DEFAULT_CAPACITY);
  }

  /**
   * Creates a writer.
   *
   * @param scene the voxels to change
   * @param boxes receives a box around the voxels of each edit
   * @param capacity the most changed bricks that can be undone, at least 1
   */
  public VoxelWriter(CollisionScene scene, EditListener boxes, int capacity) {
    this.scene = scene;
    this.boxes = boxes;
    log = new VoxelLog(this, capacity);
    history = new UndoHistory(List.of(log));
  }

  /**
   * Creates a writer whose history holds the placements of bodies too.
   *
   * @param scene the voxels to change
   * @param boxes receives a box around the voxels of each edit
   * @param placements shares the history of the voxels from now on
   */
  public VoxelWriter(CollisionScene scene, EditListener boxes, PlacementLog placements) {
    this.scene = scene;
    this.boxes = boxes;
    log = new VoxelLog(this, DEFAULT_CAPACITY);
    history = new UndoHistory(List.of(log, placements));
    placements.keepIn(history);
  }

  /**
   * Sets the receiver of each changed voxel. Call it before the first change.
   *
   * @param listener receives each change on the haptic thread
   */
  public void listen(VoxelListener listener) {
    voxels = listener;
  }

  /**
   * Limits a segment: a voxel that is not solid in {@code most} never becomes solid. Call it before
   * the first change.
   *
   * @param segment the index of the segment in the scene
   * @param most the voxels that may become solid, on the grid of the segment; kept
   */
  public void limit(int segment, BitCube most) {
    limits = Arrays.copyOf(limits, Math.max(limits.length, segment + 1));
    limits[segment] = most;
  }

  /**
   * Sets where the tool is, for edits that act there. Call it before the first change.
   *
   * @param place read on the haptic thread when an edit begins
   */
  public void follow(ToolPlace place) {
    tool = place;
  }

  /** Returns where the tool is. */
  ToolPlace tool() {
    return tool;
  }

  /** {@return the history of the changes} */
  public UndoHistory history() {
    return history;
  }

  /** Whether {@link #write} would change a voxel of the grid. */
  boolean changes(int segment, int i, int j, int k, boolean solid) {
    return scene.cube(segment).get(i, j, k) != solid && !(solid && isBeyondLimit(segment, i, j, k));
  }

  /**
   * Makes a voxel of the grid solid or empty. The caller then reports the box to {@link #applied}.
   *
   * @param segment the index of the segment in the scene
   * @param i the voxel's number along x, in the grid
   * @param j its number along y
   * @param k its number along z
   * @param solid whether the voxel becomes solid; otherwise it becomes empty
   * @return whether it changed; a voxel beyond the {@link #limit} stays empty
   */
  public boolean write(int segment, int i, int j, int k, boolean solid) {
    if (!changes(segment, i, j, k, solid)) {
      return false;
    }
    history.beforeChange();
    BitCube bits = scene.cube(segment);
    int x = i >> BitCube.BRICK_SHIFT;
    int y = j >> BitCube.BRICK_SHIFT;
    int z = k >> BitCube.BRICK_SHIFT;
    long before = bits.brick(x, y, z);
    if (solid) {
      bits.set(i, j, k);
    } else {
      bits.clear(i, j, k);
    }
    log.note(segment, x, y, z, before, bits.brick(x, y, z));
    changed.include(i, j, k);
    voxels.changed(segment, i, j, k, solid);
    return true;
  }

  private boolean isBeyondLimit(int segment, int i, int j, int k) {
    return segment < limits.length && limits[segment] != null && !limits[segment].get(i, j, k);
  }

  /**
   * Reports a box around voxels that {@link #write} may have changed; may be empty.
   *
   * @param segment the index of the segment in the scene
   * @param changed the box, in voxels; not kept
   */
  public void applied(int segment, IntBox changed) {
    boxes.applied(segment, changed);
  }

  /**
   * {@return a box around the voxels of all segments that changed since {@link #clearChanged};
   * empty if there are none} The writer goes on changing it.
   */
  public IntBox changed() {
    return changed;
  }

  /** {@return whether voxels or grey values changed since {@link #clearChanged}} */
  public boolean hasChanged() {
    return greyChanged || !changed.isEmpty();
  }

  /** {@return whether grey values changed since {@link #clearChanged}} */
  public boolean greyChanged() {
    return greyChanged;
  }

  /** Notes that grey values changed. */
  void noteGrey() {
    greyChanged = true;
  }

  /** Forgets the changes: {@link #changed} becomes empty and {@link #greyChanged} false. */
  public void clearChanged() {
    changed.clear();
    greyChanged = false;
  }

  /** Replaces the cube of a segment, which no history can undo. */
  BitCube replace(int segment, BitCube replacement) {
    history.forget();
    changed.include(0, 0, 0);
    changed.include(replacement.sizeX() - 1, replacement.sizeY() - 1, replacement.sizeZ() - 1);
    return scene.replace(segment, replacement);
  }

  /** Writes the bits of a brick that the history knows. */
  void restoreBrick(int segment, int x, int y, int z, long word) {
    BitCube bits = scene.cube(segment);
    long before = bits.brick(x, y, z);
    bits.setBrick(x, y, z, word);
    box.clear();
    for (long rest = before ^ word; rest != 0; rest &= rest - 1) {
      int bit = Long.numberOfTrailingZeros(rest);
      int i = (x << BitCube.BRICK_SHIFT) + (bit & 3);
      int j = (y << BitCube.BRICK_SHIFT) + (bit >> 2 & 3);
      int k = (z << BitCube.BRICK_SHIFT) + (bit >> 4);
      box.include(i, j, k);
      voxels.changed(segment, i, j, k, (word >>> bit & 1) != 0);
    }
    changed.include(box);
    boxes.applied(segment, box);
  }
}
