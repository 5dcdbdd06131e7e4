package org.palpate.proxy.smooth;

import org.palpate.volume.VoxelGrid;

/**
 * The grey values that a smooth surface goes by where they may change while it is touched.
 *
 * <p>The haptic thread alone replaces them, between frames, and resets its solver after it; any
 * thread reads.
 */
public final class LiveGrey {
  private volatile GreySurface now;

  /** Begins with {@code first}. */
  public LiveGrey(GreySurface first) {
    now = first;
  }

  /** What surfaces go by now. */
  public GreySurface now() {
    return now;
  }

  /** Puts other values, another threshold or contrast in their place. */
  public void replace(GreySurface fresh) {
    now = fresh;
  }

  VoxelGrid grid() {
    return now.volume().grid();
  }
}
