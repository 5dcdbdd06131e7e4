package org.palpate.io.format;

import java.io.Closeable;
import java.io.IOException;
import org.palpate.io.volume.VoxelSlice;

/** Samples of a volume in the file's order, taken or passed over. */
public interface SampleStream extends Closeable {
  /**
   * Fills {@code dest} from {@code at} with the next {@code count} samples, scaled.
   *
   * @throws java.io.EOFException where there are fewer
   */
  void read(VoxelSlice dest, int at, int count) throws IOException;

  /**
   * Passes over samples.
   *
   * @throws java.io.EOFException where there are fewer
   */
  void skip(long count) throws IOException;

  /** Begins reading at the first sample. */
  @FunctionalInterface
  interface Opener {
    /** A new stream at the first sample; the caller closes it. */
    SampleStream open() throws IOException;
  }
}
