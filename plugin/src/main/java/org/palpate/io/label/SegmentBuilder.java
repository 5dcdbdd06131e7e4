package org.palpate.io.label;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.BitCube;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Builds segments of a volume in one pass, without keeping its values. A file may have several
 * layers of labels, which come as several slices at the same k. A voxel belongs to a segment if its
 * value in one of them does. Four slices are stored as bricks when they are complete.
 */
public final class SegmentBuilder implements SliceSink {
  private static final int[] PALETTE = {
    0xE8DCC4, 0xC97B63, 0x6FA8DC, 0x93C47D, 0xF6B26B, 0x8E7CC3, 0x76A5AF, 0xC27BA0, 0xFFD966,
    0xA4C2F4
  };

  private final VoxelGrid grid;
  private final List<SegmentAccumulator> layers = new ArrayList<>();
  private final Optional<LabelLookup> dispatch;
  private int brickZ;

  /**
   * Creates a builder of segments by rules.
   *
   * @param integer whether the slices hold integers, {@code header.values().isInteger()}
   */
  private SegmentBuilder(VoxelGrid grid, List<SegmentSpec> specs, boolean integer) {
    this.grid = grid;
    for (SegmentSpec spec : specs) {
      int rgb = spec.rgb() == SegmentSpec.ANY_COLOUR ? paletteColour(layers.size()) : spec.rgb();
      layers.add(new SegmentAccumulator(spec, grid, integer, rgb));
    }
    dispatch = integer ? LabelLookup.of(specs, layers) : Optional.empty();
  }

  /** Returns the colour of a segment for which none is chosen, 0xRRGGBB. */
  public static int paletteColour(int index) {
    return PALETTE[index % PALETTE.length];
  }

  /**
   * Reads the segments of a volume.
   *
   * @throws VolumeFormatException if the volume cannot be read or its bits do not fit in memory
   */
  public static SegmentedVolume read(VolumeReader reader, List<SegmentSpec> specs)
      throws VolumeFormatException {
    return read(reader, specs, (k, slice) -> {});
  }

  /**
   * Reads the segments of a volume, and passes each slice of {@link VolumeReader#readLayers} to
   * another sink in the same pass.
   *
   * @throws VolumeFormatException if the volume cannot be read or its bits do not fit in memory
   */
  public static SegmentedVolume read(VolumeReader reader, List<SegmentSpec> specs, SliceSink beside)
      throws VolumeFormatException {
    VoxelGrid grid = reader.header().grid();
    String purpose = specs.size() == 1 ? "one segment" : specs.size() + " segments";
    MemoryCheck.require(bytesFor(grid, specs.size()), purpose, reader.sourceName());
    List<SegmentSpec> resolved = new ArrayList<>();
    for (SegmentSpec spec : specs) {
      resolved.add(spec.resolved(reader.header().labels()));
    }
    SegmentBuilder builder =
        new SegmentBuilder(grid, resolved, reader.header().values().isInteger());
    reader.readLayers(
        (k, slice) -> {
          builder.accept(k, slice);
          beside.accept(k, slice);
        });
    return builder.build();
  }

  /** Returns the number of bytes that segments of a grid take. */
  public static double bytesFor(VoxelGrid grid, int segments) {
    return segments * BitCube.bytesFor(grid.sizeX(), grid.sizeY(), grid.sizeZ());
  }

  @Override
  public void accept(int k, VoxelSlice slice) {
    if (k >> BitCube.BRICK_SHIFT != brickZ) {
      storeBrickLayer();
      brickZ = k >> BitCube.BRICK_SHIFT;
    }
    if (dispatch.isPresent()) {
      dispatch.get().addSlice(k, slice);
    } else {
      layers.forEach(layer -> layer.addSlice(k, slice));
    }
  }

  private void storeBrickLayer() {
    layers.forEach(layer -> layer.storeBrickLayer(brickZ));
  }

  /** Returns the segments after the last slice. */
  private SegmentedVolume build() {
    storeBrickLayer();
    return new SegmentedVolume(grid, layers.stream().map(SegmentAccumulator::segment).toList());
  }
}
