package org.palpate.proxy.smooth.field;

import org.palpate.volume.VoxelGrid;

/**
 * Holds the grey values of a smooth surface that may change while it is touched.
 *
 * <p>Only the haptic thread replaces them, between frames, and then resets its solver. Any thread
 * may read.
 */
public final class GreyIsosurfaceSource {
  private volatile GreyIsosurface current;

  /**
   * Creates a source.
   *
   * @param first the values with which it begins
   */
  public GreyIsosurfaceSource(GreyIsosurface first) {
    current = first;
  }

  /** {@return the present values} */
  public GreyIsosurface now() {
    return current;
  }

  /**
   * Replaces values, threshold and contrast; the grid stays the same.
   *
   * @param fresh the new values, on the same grid
   */
  public void replace(GreyIsosurface fresh) {
    current = fresh;
  }

  /** Returns the grid of the values. */
  VoxelGrid grid() {
    return current.volume().grid();
  }
}
