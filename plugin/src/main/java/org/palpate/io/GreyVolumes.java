package org.palpate.io;

import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.VoxelGrid;

/** Reads the grey values of a volume into memory. */
public final class GreyVolumes {
  private GreyVolumes() {}

  /**
   * Reads all values into the narrowest storage that the header allows.
   *
   * @throws VolumeFormatException if the values cannot be read or do not fit in memory
   */
  public static ScalarVolume read(VolumeReader reader) throws VolumeFormatException {
    VoxelGrid grid = reader.header().grid();
    Storage storage = storage(reader.header().values());
    MemoryCheck.require(
        ScalarVolume.bytesFor(grid, storage), "keeping its grey values", reader.sourceName());
    ScalarVolume volume = ScalarVolume.of(grid, storage);
    reader.read((k, slice) -> store(k, slice, volume));
    return volume;
  }

  /** Returns the number of bytes that the grey values of a volume take in memory. */
  public static double bytesFor(VolumeHeader header) {
    return ScalarVolume.bytesFor(header.grid(), storage(header.values()));
  }

  private static Storage storage(ValueRange values) {
    return values.isInteger() ? Storage.forIntegers(values.low(), values.high()) : Storage.FLOAT32;
  }

  private static void store(int k, VoxelSlice slice, ScalarVolume volume) {
    for (int j = 0; j < slice.sizeY(); j++) {
      int row = j * slice.sizeX();
      for (int i = 0; i < slice.sizeX(); i++) {
        volume.set(i, j, k, slice.value(row + i));
      }
    }
  }
}
