package org.palpate.proxy.smooth.field;

import org.palpate.volume.VoxelGrid;

/**
 * The grey values that a smooth surface goes by where they may change while it is touched.
 *
 * <p>The haptic thread alone replaces them, between frames, and resets its solver after it; any
 * thread reads.
 */
public final class GreyIsosurfaceSource {
  private volatile GreyIsosurface now;

  /** Begins with {@code first}. */
  public GreyIsosurfaceSource(GreyIsosurface first) {
    now = first;
  }

  /** What surfaces go by now. */
  public GreyIsosurface now() {
    return now;
  }

  /** Puts other values, another threshold or contrast in their place. */
  public void replace(GreyIsosurface fresh) {
    now = fresh;
  }

  VoxelGrid grid() {
    return now.volume().grid();
  }
}
