package org.palpate.io;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.PhantomSlices;

/** Reads a phantom as if it were a file. */
public final class PhantomReader implements VolumeReader {
  private final Phantom phantom;

  /** Creates a reader of a phantom, which no file holds. */
  public PhantomReader(Phantom phantom) {
    this.phantom = phantom;
  }

  @Override
  public VolumeHeader header() {
    return new VolumeHeader(
        phantom.grey() ? "phantom, grey values" : "phantom, labels",
        phantom.grid(),
        VoxelType.UINT16,
        new VolumeHeader.ValueRange(0, Phantom.SOLID_GREY, true),
        CoordinateSystem.UNKNOWN,
        phantom.grey() ? Optional.empty() : Optional.of(labelTable()),
        List.of("made by formula, not read from a file"));
  }

  private LabelTable labelTable() {
    Map<Long, LabelTable.Label> labels = new TreeMap<>();
    for (Phantom.Label label : phantom.labels()) {
      labels.put((long) label.value(), new LabelTable.Label(label.name(), label.rgb()));
    }
    return new LabelTable(labels);
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    int edge = phantom.edge();
    PhantomSlices slices = phantom.slices();
    short[] values = new short[edge * edge];
    VoxelSlice slice = new VoxelSlice(edge, edge, true);
    for (int k = 0; k < edge; k++) {
      slices.read(k, values);
      Arrays.setAll(slice.integers(), n -> values[n]);
      sink.accept(k, slice);
    }
  }

  @Override
  public String sourceName() {
    return "phantom " + phantom.spec();
  }

  @Override
  public List<Path> files() {
    return List.of();
  }
}
