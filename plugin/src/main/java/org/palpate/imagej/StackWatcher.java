package org.palpate.imagej;

import ij.ImageListener;
import ij.ImagePlus;
import ij.process.ImageProcessor;
import java.util.ArrayList;
import java.util.List;
import org.palpate.interaction.EditQueue;
import org.palpate.interaction.SwapEdit;
import org.palpate.interaction.VoxelEdit;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

/**
 * Carries what changes in the stack (paint, macro, filter) over to what is touched.
 *
 * <p>ImageJ tells that an image was updated, for scrolling too, and not where. So the listener only
 * sets a flag, and {@link #carryOver} compares every slice with a copy of the bits and queues what
 * differs: voxel by voxel, or, where there is much, a cube made aside. {@link #carryOver} is called
 * by one thread at a time.
 */
final class StackWatcher implements ImageListener, AutoCloseable {
  /** More changed voxels than this are handed over as a whole cube. */
  private static final int MOST_SINGLE_EDITS = 256;

  private final StackVolume volume;
  private final List<VoxelRule> rules;
  private final EditQueue edits;
  private final List<BitCube> mirrors = new ArrayList<>();
  private volatile boolean updated;
  private volatile boolean closed;

  /** Watches from now on. */
  StackWatcher(StackVolume volume, List<VoxelRule> rules, List<Segment> segments, EditQueue edits) {
    this.volume = volume;
    this.rules = rules;
    this.edits = edits;
    segments.forEach(segment -> mirrors.add(segment.bits().copy()));
    ImagePlus.addImageListener(this);
  }

  @Override
  public void imageOpened(ImagePlus image) {}

  @Override
  public void imageUpdated(ImagePlus image) {
    updated |= image == volume.image();
  }

  @Override
  public void imageClosed(ImagePlus image) {
    closed |= image == volume.image();
  }

  /** Whether the image was closed. */
  boolean isClosed() {
    return closed;
  }

  /**
   * Carries over what changed since the last call, where ImageJ told of a change. Returns the
   * voxels that changed.
   */
  int carryOverWhenUpdated() {
    if (!updated) {
      return 0;
    }
    updated = false;
    return carryOver();
  }

  /** Carries over what changed. */
  synchronized int carryOver() {
    int changed = 0;
    for (int n = 0; n < mirrors.size(); n++) {
      changed += carryOver(n);
    }
    return changed;
  }

  private int carryOver(int segment) {
    List<VoxelEdit> single = new ArrayList<>();
    int changed = 0;
    for (int k = 0; k < volume.slices(); k++) {
      changed += compare(segment, k, single);
    }
    if (changed > MOST_SINGLE_EDITS || !single.stream().allMatch(edits::offer)) {
      offerWhole(segment);
    }
    return changed;
  }

  private int compare(int segment, int k, List<VoxelEdit> single) {
    BitCube mirror = mirrors.get(segment);
    VoxelRule rule = rules.get(segment);
    ImageProcessor slice = volume.slice(k);
    int width = volume.width();
    int changed = 0;
    for (int n = 0; n < slice.getPixelCount(); n++) {
      boolean solid = rule.holds(slice.getf(n));
      int i = n % width;
      int j = n / width;
      if (solid != mirror.get(i, j, k)) {
        put(mirror, i, j, k, solid);
        changed++;
        if (single.size() < MOST_SINGLE_EDITS) {
          single.add(new VoxelEdit(segment, i, j, k, solid));
        }
      }
    }
    return changed;
  }

  private static void put(BitCube mirror, int i, int j, int k, boolean solid) {
    if (solid) {
      mirror.set(i, j, k);
    } else {
      mirror.clear(i, j, k);
    }
  }

  /** A queue that is full stays as it is: the next update compares again and finds the same. */
  private void offerWhole(int segment) {
    BitCube fresh = mirrors.get(segment).copy();
    fresh.tightenBounds();
    updated |= !edits.offer(new SwapEdit(segment, fresh));
  }

  @Override
  public void close() {
    ImagePlus.removeImageListener(this);
  }
}
