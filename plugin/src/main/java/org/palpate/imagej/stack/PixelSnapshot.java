package org.palpate.imagej.stack;

import java.util.Arrays;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A copy of a stack's pixels that finds the pixels that have changed. As large as the stack; one
 * thread.
 */
public final class PixelSnapshot {
  private final StackVolume volume;
  private final Object[] slices;

  /**
   * Copies the stack.
   *
   * @throws TouchRefusedException if the size or type of the stack has changed
   */
  public PixelSnapshot(StackVolume volume) throws TouchRefusedException {
    this.volume = volume;
    slices = new Object[volume.slices()];
    for (int k = 0; k < slices.length; k++) {
      slices[k] = copy(volume.pixels(k));
    }
  }

  /** Returns the copied pixels of slice k, counted from 0. Read-only. */
  public Object slice(int k) {
    return slices[k];
  }

  /**
   * Returns the copied values as a volume over a grid of the stack's size. Later changes do not
   * reach it.
   */
  ScalarVolume values(VoxelGrid grid) {
    return ScalarVolume.over(grid, slices);
  }

  /** Receives the changed pixels. */
  @FunctionalInterface
  interface Sink {
    /** Receives the new raw value of pixel n of slice k, both counted from 0. */
    void accept(int n, int k, float value);
  }

  /**
   * Reports every pixel that changed after the last call, slice by slice.
   *
   * @throws TouchRefusedException if the size or type of the stack has changed
   */
  void changes(Sink sink) throws TouchRefusedException {
    for (int k = 0; k < slices.length; k++) {
      Object now = volume.pixels(k);
      if (!same(slices[k], now)) {
        // The stack may go on changing, so the reported and the kept pixels are the same copy.
        Object fresh = copy(now);
        reportChanges(k, slices[k], fresh, sink);
        slices[k] = fresh;
      }
    }
  }

  private static void reportChanges(int k, Object before, Object after, Sink sink) {
    int pixels = StackVolume.pixelCount(after);
    for (int n = 0; n < pixels; n++) {
      float fresh = StackVolume.value(after, n);
      if (fresh != StackVolume.value(before, n)) {
        sink.accept(n, k, fresh);
      }
    }
  }

  private static boolean same(Object a, Object b) {
    if (a instanceof byte[] x && b instanceof byte[] y) {
      return Arrays.equals(x, y);
    }
    if (a instanceof short[] x && b instanceof short[] y) {
      return Arrays.equals(x, y);
    }
    return a instanceof float[] x && b instanceof float[] y && Arrays.equals(x, y);
  }

  private static Object copy(Object pixels) {
    if (pixels instanceof byte[] bytes) {
      return bytes.clone();
    }
    return pixels instanceof short[] shorts ? shorts.clone() : ((float[]) pixels).clone();
  }
}
