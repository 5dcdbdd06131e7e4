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
 * Carries what changes in the stack (paint, macro, filter, threshold) over to what is touched and
 * seen.
 *
 * <p>ImageJ tells that an image was updated, for scrolling too, and not where. So the listener only
 * sets a flag, and {@link #applyChanges} compares every slice with a copy and queues what differs:
 * voxel by voxel, or, where there is much, a cube made aside. One thread carries over; any may set
 * the flag.
 */
public final class StackSynchronizer implements ImageListener, AutoCloseable {
  /** More changed voxels than this are handed over as a whole cube. */
  private static final int MAX_SINGLE_EDITS = 256;

  private final StackVolume volume;
  private final List<SegmentRange> rules;
  private final boolean followsThreshold;
  private final EditQueue edits;
  private final PixelSnapshot pixels;
  private final StackGreyValues grey;
  private final List<Changes> segments = new ArrayList<>();
  private final Listener listener;
  private long compared;
  private volatile boolean updated;
  private volatile boolean closed;

  /** Whom a watcher tells. */
  public interface Listener {
    /** The image was updated or closed: there may be something to carry over. Any thread. */
    void updated();

    /** Voxels of a segment changed inside a box. The thread that carries over. */
    void changed(IntBox voxels, int segment);
  }

  /** What changed of a segment since the last time. */
  private static final class Changes {
    private final BitCube mirror;
    private final List<VoxelEdit> single = new ArrayList<>();
    private final IntBox box = new IntBox();
    private int count;
    private volatile long solidsTold;
    private boolean waits;

    private Changes(BitCube mirror) {
      this.mirror = mirror;
      solidsTold = mirror.solidCount();
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
      if (single.size() < MAX_SINGLE_EDITS) {
        single.add(new VoxelEdit(segment, i, j, k, solid));
      }
    }

    private void clear() {
      solidsTold = mirror.solidCount();
      single.clear();
      box.clear();
      count = 0;
    }
  }

  /**
   * Watches from now on.
   *
   * @param rules what makes the segments, in their order
   * @param pixels the stack as the segments were made of it
   * @param followsThreshold whether the one segment is what the image's threshold marks
   * @param scene what is touched, as it was made of the stack
   */
  public StackSynchronizer(
      StackVolume volume,
      PixelSnapshot pixels,
      List<SegmentRange> rules,
      boolean followsThreshold,
      ContactScene scene,
      Listener listener) {
    this.volume = volume;
    this.rules = new ArrayList<>(rules);
    this.followsThreshold = followsThreshold;
    this.listener = listener;
    this.pixels = pixels;
    edits = scene.edits();
    grey = new StackGreyValues(scene, pixels);
    scene.volume().segments().forEach(segment -> segments.add(new Changes(segment.bits().copy())));
    ImagePlus.addImageListener(this);
  }

  /** The bits of each segment as the stack had them last, for drawing. This watcher's own. */
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

  /** The solid voxels of a segment, of the last time that all was carried over. Any thread. */
  public long solids(int segment) {
    return segments.get(segment).solidsTold;
  }

  /** Whether the image was closed. */
  public boolean isClosed() {
    return closed;
  }

  /** Says that the stack was written to. Any thread. */
  public void markUpdated() {
    updated = true;
    listener.updated();
  }

  /**
   * Carries over what changed since the last call, where there was an update.
   *
   * @return the voxels that changed, over all segments
   * @throws TouchRefusedException where the stack got another size or type
   */
  public int applyChanges() throws TouchRefusedException {
    if (!updated) {
      return 0;
    }
    updated = false;
    compared = 0;
    pixels.changes(this::compare);
    if (followsThreshold && thresholdMoved()) {
      recompute();
    }
    int changed = 0;
    for (int n = 0; n < segments.size(); n++) {
      changed += handOver(n);
    }
    long all = (long) volume.width() * volume.height() * volume.slices();
    grey.carryOver(rules.get(0), compared, all);
    updated |= grey.waits();
    return changed;
  }

  private boolean thresholdMoved() {
    SegmentRange before = rules.get(0);
    SegmentRange now = before.withThresholdOf(volume.image());
    rules.set(0, now);
    return !now.equals(before);
  }

  /** Compares every voxel, for another rule. */
  private void recompute() {
    SegmentRange rule = rules.get(0);
    for (int k = 0; k < volume.slices(); k++) {
      Object slice = pixels.slice(k);
      int count = StackVolume.pixelCount(slice);
      for (int n = 0; n < count; n++) {
        boolean solid = rule.holds(StackVolume.value(slice, n));
        segments.get(0).put(0, n % volume.width(), n / volume.width(), k, solid);
      }
    }
  }

  private void compare(int n, int k, float value) {
    compared++;
    int i = n % volume.width();
    int j = n / volume.width();
    for (int s = 0; s < segments.size(); s++) {
      segments.get(s).put(s, i, j, k, rules.get(s).holds(value));
    }
  }

  private int handOver(int n) {
    Changes segment = segments.get(n);
    int count = segment.count;
    if (count == 0 && !segment.waits) {
      return 0;
    }
    boolean whole =
        segment.waits
            || count > MAX_SINGLE_EDITS
            || !segment.single.stream().allMatch(edits::offer);
    if (whole) {
      offerWhole(n, segment);
    }
    if (count > 0) {
      listener.changed(new IntBox().set(segment.box), n);
    }
    segment.clear();
    return count;
  }

  /** A queue that is full leaves it for the next time. */
  private void offerWhole(int n, Changes segment) {
    BitCube fresh = segment.mirror.copy();
    fresh.tightenBounds();
    segment.waits = !edits.offer(new SwapEdit(n, fresh));
    updated |= segment.waits;
  }

  @Override
  public void close() {
    ImagePlus.removeImageListener(this);
  }
}
