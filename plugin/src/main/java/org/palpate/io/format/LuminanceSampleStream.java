package org.palpate.io.format;

import java.io.IOException;
import org.palpate.io.volume.VoxelSlice;

/** Reads colours from a stream of their parts as luminance, and closes the stream. */
public final class LuminanceSampleStream implements SampleStream {
  private static final int PIXELS = 4096;

  private final SampleStream parts;
  private final int components;
  private final VoxelSlice colours;

  /**
   * Creates a stream of luminance.
   *
   * @param parts red, green, blue and perhaps more of each colour, integers of at most 16 bits
   * @param components parts of a colour, at least 3
   */
  public LuminanceSampleStream(SampleStream parts, int components) {
    this.parts = parts;
    this.components = components;
    colours = new VoxelSlice(components, PIXELS, true);
  }

  @Override
  public void read(VoxelSlice dest, int at, int count) throws IOException {
    for (int done = 0; done < count; ) {
      int some = Math.min(PIXELS, count - done);
      parts.read(colours, 0, some * components);
      for (int n = 0; n < some; n++) {
        int[] rgb = colours.integers();
        int first = n * components;
        dest.integers()[at + done + n] = Luminance.of(rgb[first], rgb[first + 1], rgb[first + 2]);
      }
      done += some;
    }
  }

  @Override
  public void skip(long count) throws IOException {
    parts.skip(count * components);
  }

  @Override
  public void close() throws IOException {
    parts.close();
  }
}
