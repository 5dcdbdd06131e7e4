package org.palpate.io.format;

import java.io.Closeable;
import java.io.IOException;
import org.palpate.io.volume.VoxelSlice;

/** Reads or skips the samples of a volume in file order. */
public interface SampleStream extends Closeable {
  /**
   * Reads the next {@code count} samples, scaled, into {@code dest} from index {@code at}.
   *
   * @throws java.io.EOFException if there are fewer
   */
  void read(VoxelSlice dest, int at, int count) throws IOException;

  /**
   * Skips samples.
   *
   * @throws java.io.EOFException if there are fewer
   */
  void skip(long count) throws IOException;

  /** Opens streams of samples. */
  @FunctionalInterface
  interface Opener {
    /** Returns a new stream at the first sample, which the caller closes. */
    SampleStream open() throws IOException;
  }
}
