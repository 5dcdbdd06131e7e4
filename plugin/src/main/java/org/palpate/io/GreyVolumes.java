package org.palpate.io;

import java.util.List;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.ScalarVolume.Storage;
import org.palpate.volume.SegmentedVolume;
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
    ScalarVolume volume = zeros(reader);
    reader.read((k, slice) -> store(k, slice, volume));
    return volume;
  }

  /**
   * Reads segments and all values in one pass over the file.
   *
   * @throws VolumeFormatException if the volume cannot be read or does not fit in memory
   */
  public static WithSegments readWithSegments(VolumeReader reader, List<SegmentSpec> specs)
      throws VolumeFormatException {
    ScalarVolume volume = zeros(reader);
    SegmentedVolume segments =
        SegmentBuilder.read(reader, specs, (k, slice) -> store(k, slice, volume));
    return new WithSegments(segments, volume);
  }

  /**
   * The segments of a volume and the grey values from which they were made.
   *
   * @param segments the bits, over the grid of the values
   * @param values all grey values; where labels overlap, the value of the last one
   */
  public record WithSegments(SegmentedVolume segments, ScalarVolume values) {}

  private static ScalarVolume zeros(VolumeReader reader) throws VolumeFormatException {
    VoxelGrid grid = reader.header().grid();
    Storage storage = storage(reader.header().values());
    MemoryCheck.require(
        ScalarVolume.bytesFor(grid, storage), "keeping its grey values", reader.sourceName());
    return ScalarVolume.of(grid, storage);
  }

  /** Returns the number of bytes that the grey values of a volume take in memory. */
  public static double bytesFor(VolumeHeader header) {
    return ScalarVolume.bytesFor(header.grid(), storage(header.values()));
  }

  private static Storage storage(ValueRange values) {
    return values.isInteger() ? Storage.forIntegers(values.low(), values.high()) : Storage.FLOAT32;
  }

  /** Stores a slice over zeros or over an earlier layer of labels, where 0 is empty. */
  private static void store(int k, VoxelSlice slice, ScalarVolume volume) {
    for (int j = 0; j < slice.sizeY(); j++) {
      int row = j * slice.sizeX();
      for (int i = 0; i < slice.sizeX(); i++) {
        double value = slice.value(row + i);
        if (value != 0) {
          volume.set(i, j, k, value);
        }
      }
    }
  }
}
