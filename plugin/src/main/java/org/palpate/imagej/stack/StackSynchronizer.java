package org.palpate.imagej.stack;

import ij.ImageListener;
import ij.ImagePlus;
import java.util.ArrayList;
import java.util.List;
import org.palpate.edit.EditQueue;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.geometry.IntBox;
import org.palpate.host.ContactScene;
import org.palpate.volume.BitCube;

/**
 * Applies changes of the stack (paint, macro, filter, threshold) to the touched segments and to the
 * drawn ones.
 *
 * <p>ImageJ reports that an image was updated, also after scrolling, but not where. The listener
 * therefore only sets a flag, and {@link #applyChanges} compares every slice with a copy. It queues
 * the differences voxel by voxel or, if there are many, as a whole cube. One thread applies
 * changes; any thread may set the flag.
 */
public final class StackSynchronizer implements ImageListener, AutoCloseable {
  /** The most changed voxels that are queued one by one; more are queued as a whole cube. */
  private static final int MAX_SINGLE_EDITS = 256;

  private final StackVolume volume;
  private final List<SegmentRange> ranges;
  private final boolean followsThreshold;
  private final EditQueue edits;
  private final PixelSnapshot pixels;
  private final StackGreyValues grey;
  private final List<Changes> segments = new ArrayList<>();
  private final Listener listener;
  private long compared;
  private volatile boolean updated;
  private volatile boolean closed;

  /** Receives the changes. */
  public interface Listener {
    /** Reports that the image was updated or closed. Any thread. */
    void updated();

    /** Reports the new value of a voxel of the stack. On the thread that applies changes. */
    void seen(int i, int j, int k, float value);

    /**
     * Reports that voxels of a segment changed inside a box. On the thread that applies changes.
     */
    void changed(IntBox voxels, int segment);
  }

  /** The changes of a segment after the last call. */
  private static final class Changes {
    private final BitCube mirror;
    private final List<VoxelEdit> singleEdits = new ArrayList<>();
    private final IntBox box = new IntBox();
    private int count;
    private volatile long solidCount;
    private boolean isPending;

    private Changes(BitCube mirror) {
      this.mirror = mirror;
      solidCount = mirror.solidCount();
    }

    private void put(int segment, int i, int j, int k, boolean solid) {
      if (solid == mirror.get(i, j, k)) {
        return;
      }
      if (solid) {
        mirror.set(i, j, k);
      } else {
        mirror.clear(i, j, k);
      }
      count++;
      box.include(i, j, k);
      if (singleEdits.size() < MAX_SINGLE_EDITS) {
        singleEdits.add(new VoxelEdit(segment, i, j, k, solid));
      }
    }

    private void clear() {
      solidCount = mirror.solidCount();
      singleEdits.clear();
      box.clear();
      count = 0;
    }
  }

  /**
   * Starts to listen for updates of the image.
   *
   * @param pixels copy of the stack from which the segments were built
   * @param ranges values of the segments, in their order
   * @param followsThreshold whether the one segment follows the image's threshold
   * @param scene the touched scene, built from the stack
   */
  public StackSynchronizer(
      StackVolume volume,
      PixelSnapshot pixels,
      List<SegmentRange> ranges,
      boolean followsThreshold,
      ContactScene scene,
      Listener listener) {
    this.volume = volume;
    this.ranges = new ArrayList<>(ranges);
    this.followsThreshold = followsThreshold;
    this.listener = listener;
    this.pixels = pixels;
    edits = scene.edits();
    grey = new StackGreyValues(scene, pixels);
    scene.volume().segments().forEach(segment -> segments.add(new Changes(segment.bits().copy())));
    ImagePlus.addImageListener(this);
  }

  /**
   * Returns the bits of each segment after the last change, for drawing. Owned by this
   * synchronizer.
   */
  public List<BitCube> mirrors() {
    return segments.stream().map(segment -> segment.mirror).toList();
  }

  @Override
  public void imageOpened(ImagePlus image) {}

  @Override
  public void imageUpdated(ImagePlus image) {
    if (image == volume.image()) {
      markUpdated();
    }
  }

  @Override
  public void imageClosed(ImagePlus image) {
    if (image == volume.image()) {
      closed = true;
      listener.updated();
    }
  }

  /** Returns the number of solid voxels of a segment after the last applied change. Any thread. */
  public long solidCount(int segment) {
    return segments.get(segment).solidCount;
  }

  /** Whether the image was closed. */
  public boolean isClosed() {
    return closed;
  }

  /** Records that the stack was written to. Any thread. */
  public void markUpdated() {
    updated = true;
    listener.updated();
  }

  /**
   * Applies the changes after the last call, if there was an update.
   *
   * @return number of changed voxels over all segments
   * @throws TouchRefusedException if the size or type of the stack has changed
   */
  public int applyChanges() throws TouchRefusedException {
    if (!updated) {
      return 0;
    }
    updated = false;
    compared = 0;
    pixels.changes(this::compare);
    if (followsThreshold && updateThreshold()) {
      recompute();
    }
    int changed = 0;
    for (int n = 0; n < segments.size(); n++) {
      changed += queueEdits(n);
    }
    long all = (long) volume.width() * volume.height() * volume.slices();
    grey.applyChanges(ranges.get(0), compared, all);
    updated |= grey.isPending();
    return changed;
  }

  private boolean updateThreshold() {
    SegmentRange before = ranges.get(0);
    SegmentRange now = before.withThresholdOf(volume.image());
    ranges.set(0, now);
    return !now.equals(before);
  }

  /** Compares every voxel with the new range. */
  private void recompute() {
    SegmentRange range = ranges.get(0);
    for (int k = 0; k < volume.slices(); k++) {
      Object slice = pixels.slice(k);
      int count = StackVolume.pixelCount(slice);
      for (int n = 0; n < count; n++) {
        boolean solid = range.contains(StackVolume.value(slice, n));
        segments.get(0).put(0, n % volume.width(), n / volume.width(), k, solid);
      }
    }
  }

  private void compare(int n, int k, float value) {
    compared++;
    int i = n % volume.width();
    int j = n / volume.width();
    listener.seen(i, j, k, value);
    for (int s = 0; s < segments.size(); s++) {
      segments.get(s).put(s, i, j, k, ranges.get(s).contains(value));
    }
  }

  private int queueEdits(int n) {
    Changes segment = segments.get(n);
    int count = segment.count;
    if (count == 0 && !segment.isPending) {
      return 0;
    }
    boolean whole =
        segment.isPending
            || count > MAX_SINGLE_EDITS
            || !segment.singleEdits.stream().allMatch(edits::offer);
    if (whole) {
      offerWhole(n, segment);
    }
    if (count > 0) {
      listener.changed(new IntBox().set(segment.box), n);
    }
    segment.clear();
    return count;
  }

  /** Queues the whole cube; if the queue is full, it is queued with the next call. */
  private void offerWhole(int n, Changes segment) {
    BitCube cube = segment.mirror.copy();
    cube.tightenBounds();
    segment.isPending = !edits.offer(new SwapEdit(n, cube));
    updated |= segment.isPending;
  }

  @Override
  public void close() {
    ImagePlus.removeImageListener(this);
  }
}
