package org.palpate.io.volume;

/** Receives the slices of a volume while it is read. */
@FunctionalInterface
public interface SliceSink {
  /**
   * Receives slice {@code k}. Slices arrive in order, each once. {@link VolumeReader#readLayers}
   * passes each slice once for every layer. The reader reuses the slice after this returns.
   *
   * @throws VolumeFormatException if the values make it pointless to read on
   */
  void accept(int k, VoxelSlice slice) throws VolumeFormatException;
}
