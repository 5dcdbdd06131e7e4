package org.palpate.imagej.stack;

import java.util.Arrays;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * A copy of a stack's pixels, to find out which slices and pixels have changed since. As large as
 * the stack; one thread.
 */
public final class PixelSnapshot {
  private final StackVolume volume;
  private final Object[] slices;

  /**
   * Copies the stack as it is now.
   *
   * @throws TouchRefusedException where it is no grey stack of its former size any more
   */
  public PixelSnapshot(StackVolume volume) throws TouchRefusedException {
    this.volume = volume;
    slices = new Object[volume.slices()];
    for (int k = 0; k < slices.length; k++) {
      slices[k] = copy(volume.pixels(k));
    }
  }

  /** The copied pixels of slice k, from 0; not to be changed. */
  public Object slice(int k) {
    return slices[k];
  }

  /**
   * The copied values as a volume over a grid of the stack's size; later changes do not reach it.
   */
  ScalarVolume values(VoxelGrid grid) {
    return ScalarVolume.over(grid, slices);
  }

  /** Takes pixels that differ from the copy. */
  @FunctionalInterface
  interface Sink {
    /** Pixel n of slice k, from 0, has another raw value now. */
    void accept(int n, int k, float value);
  }

  /**
   * Tells of every pixel that changed since it was asked last, slice by slice.
   *
   * @throws TouchRefusedException where the stack got another size or type
   */
  void changes(Sink sink) throws TouchRefusedException {
    for (int k = 0; k < slices.length; k++) {
      Object now = volume.pixels(k);
      if (!same(slices[k], now)) {
        // The stack goes on changing: what is told and what is kept are the same copy.
        Object fresh = copy(now);
        tell(k, slices[k], fresh, sink);
        slices[k] = fresh;
      }
    }
  }

  private static void tell(int k, Object before, Object after, Sink sink) {
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
