package org.palpate.io.format;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.io.volume.ReadProgress;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;

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
    VoxelSlice slice = MemoryCheck.slice(header.grid(), header.values().isInteger(), sourceName());
    SliceLoop.read(
        this,
        progress,
        this::openAtChosenStep,
        (samples, k) -> {
          readSlice(samples, slice);
          sink.accept(k, slice);
        });
  }

  private SampleStream openAtChosenStep() throws IOException {
    SampleStream samples = opener.open();
    try {
      samples.skip(extra.position() == 3 ? extra.chosen() * header.grid().voxelCount() : 0);
      return samples;
    } catch (IOException e) {
      samples.close();
      throw e;
    }
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
