package org.palpate.io.format;

import java.io.EOFException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.volume.ReadProgress;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.VoxelGrid;

/** Reads a volume whose samples form one stream. */
public final class StreamVolumeReader implements VolumeReader {
  private final VolumeHeader header;
  private final List<Path> files;
  private final SampleStream.Opener opener;
  private final NonSpatialAxis extra;
  private final ReadProgress progress;

  /** Creates a reader; the first of the files names the volume in messages. */
  public StreamVolumeReader(
      VolumeHeader header,
      List<Path> files,
      SampleStream.Opener opener,
      NonSpatialAxis extra,
      ReadProgress progress) {
    this.header = header;
    this.files = List.copyOf(files);
    this.opener = opener;
    this.extra = extra;
    this.progress = progress;
  }

  @Override
  public VolumeHeader header() {
    return header;
  }

  @Override
  public String sourceName() {
    return files.get(0).toString();
  }

  @Override
  public List<Path> files() {
    return files;
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    VoxelGrid grid = header.grid();
    VoxelSlice slice = MemoryCheck.slice(grid, header.values().isInteger(), sourceName());
    int k = 0;
    try (SampleStream samples = opener.open()) {
      if (extra.position() == 3) {
        samples.skip(extra.chosen() * grid.voxelCount());
      }
      for (; k < grid.sizeZ(); k++) {
        readSlice(samples, slice);
        sink.accept(k, slice);
        progress.slicesRead(k + 1, grid.sizeZ());
      }
    } catch (VolumeFormatException e) {
      throw e;
    } catch (EOFException e) {
      throw new VolumeFormatException(
          "the data end after " + k + " of " + grid.sizeZ() + " slices",
          sourceName(),
          "copy the file again",
          e);
    } catch (IOException e) {
      throw unreadable(e, k);
    }
  }

  private VolumeFormatException unreadable(IOException e, int k) {
    return new VolumeFormatException(
        "the data are damaged in slice " + k + " (" + e.getMessage() + ")",
        sourceName(),
        "copy or export the file again",
        e);
  }

  private void readSlice(SampleStream samples, VoxelSlice slice) throws IOException {
    if (extra.position() == 3) {
      samples.read(slice, 0, slice.count());
      return;
    }
    int run = extra.contiguousSamples(slice.sizeX(), slice.sizeY());
    for (int at = 0; at < slice.count(); at += run) {
      samples.skip((long) extra.chosen() * run);
      samples.read(slice, at, run);
      samples.skip((long) (extra.count() - 1 - extra.chosen()) * run);
    }
  }
}
