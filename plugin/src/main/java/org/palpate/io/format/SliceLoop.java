package org.palpate.io.format;

import java.io.Closeable;
import java.io.EOFException;
import java.io.IOException;
import org.palpate.io.volume.ReadProgress;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;

/** Reads a volume slice by slice from a source, and names the slice that is damaged. */
public final class SliceLoop {
  private SliceLoop() {}

  /** Opens the source of the samples. */
  @FunctionalInterface
  public interface Opener<S extends Closeable> {
    /** Returns the source at its first slice; the loop closes it. */
    S open() throws IOException;
  }

  /** Reads one slice and passes it on. */
  @FunctionalInterface
  public interface Step<S extends Closeable> {
    /** Reads slice {@code k} from the source. The loop calls it in the order of the slices. */
    void read(S source, int k) throws IOException;
  }

  /**
   * Reads all slices of a volume.
   *
   * @throws VolumeFormatException if a slice is incomplete or damaged, or a step refuses it
   */
  public static <S extends Closeable> void read(
      VolumeReader volume, ReadProgress progress, Opener<S> opener, Step<S> step)
      throws VolumeFormatException {
    int count = volume.header().grid().sizeZ();
    int k = 0;
    try (S source = opener.open()) {
      for (; k < count; k++) {
        step.read(source, k);
        progress.slicesRead(k + 1, count);
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (EOFException e) {
      throw new VolumeFormatException(
          "the data end after " + k + " of " + count + " slices",
          volume.sourceName(),
          "copy the file again",
          e);
    } catch (IOException e) {
      throw new VolumeFormatException(
          "the data are damaged in slice " + k + " (" + e.getMessage() + ")",
          volume.sourceName(),
          "copy or export the file again",
          e);
    }
  }
}
