package org.palpate.io.volume;

/** Takes the slices of a volume while it is read. */
@FunctionalInterface
public interface SliceSink {
  /**
   * Takes slice {@code k}; slices come in order, each once. The slice is the reader's and changes
   * after this returns.
   *
   * @throws VolumeFormatException where the values make it pointless to read on
   */
  void accept(int k, VoxelSlice slice) throws VolumeFormatException;
}
