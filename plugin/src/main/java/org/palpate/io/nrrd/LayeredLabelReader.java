package org.palpate.io.nrrd;

import java.io.Closeable;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.format.NonSpatialAxis;
import org.palpate.io.format.SampleStream;
import org.palpate.io.format.SliceLoop;
import org.palpate.io.volume.ReadProgress;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.VoxelGrid;

/**
 * Reads a segmentation of 3D Slicer whose segments overlap: several layers of labels over one grid.
 *
 * <p>A value is the number of a segment, from 1, so that no label of one layer is taken for one of
 * another. A label without a segment is left out, as in 3D Slicer. If the segments of several
 * layers share a voxel, {@link #read} gives the one of the last layer, and {@link #readLayers}
 * gives all.
 */
final class LayeredLabelReader implements VolumeReader {
  private final VolumeHeader header;
  private final List<Path> files;
  private final SampleStream.Opener opener;
  private final NonSpatialAxis layers;
  private final List<Map<Integer, Integer>> numbers = new ArrayList<>();
  private final ReadProgress progress;

  /**
   * Creates a reader.
   *
   * @param header the header, with the labels by the numbers of the segments
   * @param files the first names the volume in messages
   * @param layers the axis of the layers
   * @param segments labels and layers of the segments
   */
  LayeredLabelReader(
      VolumeHeader header,
      List<Path> files,
      SampleStream.Opener opener,
      NonSpatialAxis layers,
      SlicerSegments segments,
      ReadProgress progress) {
    this.header = header;
    this.files = List.copyOf(files);
    this.opener = opener;
    this.layers = layers;
    this.progress = progress;
    for (int layer = 0; layer < layers.count(); layer++) {
      numbers.add(segments.numbers(layer));
    }
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
    VoxelSlice merged = newSlice();
    readLayers(
        (k, layer, slice) -> {
          for (int n = 0; n < merged.count(); n++) {
            int value = slice.integers()[n];
            merged.integers()[n] = layer == 0 || value != 0 ? value : merged.integers()[n];
          }
          if (layer == layers.count() - 1) {
            sink.accept(k, merged);
          }
        });
  }

  @Override
  public void readLayers(SliceSink sink) throws VolumeFormatException {
    readLayers((k, layer, slice) -> sink.accept(k, slice));
  }

  /** Receives the slices layer by layer. */
  private interface LayerSink {
    void accept(int k, int layer, VoxelSlice slice) throws VolumeFormatException;
  }

  private VoxelSlice newSlice() throws VolumeFormatException {
    return MemoryCheck.slice(header.grid(), true, sourceName());
  }

  private void readLayers(LayerSink sink) throws VolumeFormatException {
    List<VoxelSlice> slices = new ArrayList<>();
    for (int layer = 0; layer < layers.count(); layer++) {
      slices.add(newSlice());
    }
    SliceLoop.read(
        this,
        progress,
        LayerStreams::new,
        (streams, k) -> {
          streams.readSlice(slices);
          for (int layer = 0; layer < slices.size(); layer++) {
            number(layer, slices.get(layer));
            sink.accept(k, layer, slices.get(layer));
          }
        });
  }

  /** Replaces the labels of a layer by the numbers of their segments; 0 for a label of none. */
  private void number(int layer, VoxelSlice slice) {
    int[] values = slice.integers();
    int label = 0;
    int number = 0;
    for (int n = 0; n < values.length; n++) {
      if (values[n] != label) {
        label = values[n];
        number = numbers.get(layer).getOrDefault(label, 0);
      }
      values[n] = number;
    }
  }

  /** One stream if the layers alternate within a slice, else one for each layer. */
  private final class LayerStreams implements Closeable {
    private final List<SampleStream> streams = new ArrayList<>();

    LayerStreams() throws IOException {
      int count = layers.position() == 3 ? layers.count() : 1;
      try {
        for (int n = 0; n < count; n++) {
          streams.add(opener.open());
          streams.get(n).skip(n * header.grid().voxelCount());
        }
      } catch (IOException e) {
        close();
        throw e;
      }
    }

    void readSlice(List<VoxelSlice> dest) throws IOException {
      VoxelGrid grid = header.grid();
      int run = layers.contiguousSamples(grid.sizeX(), grid.sizeY());
      for (int at = 0; at < dest.get(0).count(); at += run) {
        for (int layer = 0; layer < dest.size(); layer++) {
          streams.get(layer % streams.size()).read(dest.get(layer), at, run);
        }
      }
    }

    @Override
    public void close() throws IOException {
      for (SampleStream stream : streams) {
        stream.close();
      }
    }
  }
}
