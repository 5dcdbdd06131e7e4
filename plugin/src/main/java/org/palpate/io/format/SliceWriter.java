package org.palpate.io.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VoxelSlice;

/** Writes the slices of a volume, in the order in which a reader delivers them. */
@FunctionalInterface
public interface SliceWriter {
  /**
   * Writes slice {@code k}.
   *
   * @throws IOException if the target cannot be written
   */
  void write(int k, VoxelSlice slice) throws IOException;

  /** A method of a volume that reads its slices. */
  @FunctionalInterface
  interface Reading {
    /** Reads all slices. */
    void read(SliceSink sink) throws VolumeFormatException;
  }

  /**
   * Reads all slices into a writer. A failure to write passes through with its cause.
   *
   * @throws VolumeFormatException if the volume cannot be read
   * @throws IOException if the target cannot be written
   */
  static void writeAll(Reading volume, SliceWriter writer) throws IOException {
    try {
      volume.read(
          (k, slice) -> {
            try {
              writer.write(k, slice);
            } catch (IOException e) {
              throw new UncheckedIOException(e);
            }
          });
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}
