package org.palpate.io.label;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.LabelTable;
import org.palpate.io.volume.LabelTable.Label;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Reads segments as a label volume, so that they can be written: 0 is empty, 1 the first segment,
 * and so on. If two overlap, the later one wins. Nobody may edit the segments meanwhile.
 */
public final class SegmentsAsLabels implements VolumeReader {
  private final String name;
  private final SegmentedVolume volume;
  private final VolumeHeader header;
  private final List<Path> files;

  /** Creates a reader of segments in a coordinate system. */
  public SegmentsAsLabels(SegmentedVolume volume, CoordinateSystem coordinateSystem) {
    this("segments", volume, coordinateSystem, List.of(), List.of());
  }

  /**
   * Creates a reader of segments in a coordinate system.
   *
   * @param name the source as messages name it
   * @param files the files from which the segments were made
   * @param notes what the user should know, a sentence each
   * @throws IllegalArgumentException if the segments have several grids
   */
  public SegmentsAsLabels(
      String name,
      SegmentedVolume volume,
      CoordinateSystem coordinateSystem,
      List<Path> files,
      List<String> notes) {
    if (!volume.hasOneGrid()) {
      throw new IllegalArgumentException("labels need one grid");
    }
    this.name = name;
    this.files = List.copyOf(files);
    this.volume = volume;
    Map<Long, Label> labels = new TreeMap<>();
    for (Segment segment : volume.segments()) {
      labels.put(labels.size() + 1L, new Label(segment.name(), segment.rgb()));
    }
    VoxelType type = labels.size() < 256 ? VoxelType.UINT8 : VoxelType.UINT16;
    header =
        new VolumeHeader(
            "segments",
            volume.grid(),
            type,
            ValueRange.of(type),
            coordinateSystem,
            Optional.of(new LabelTable(labels)),
            notes);
  }

  @Override
  public VolumeHeader header() {
    return header;
  }

  @Override
  public void read(SliceSink sink) throws VolumeFormatException {
    VoxelGrid grid = volume.grid();
    VoxelSlice slice = MemoryCheck.slice(grid, true, sourceName());
    for (int k = 0; k < grid.sizeZ(); k++) {
      Arrays.fill(slice.integers(), 0);
      for (int n = 0; n < volume.segments().size(); n++) {
        paint(volume.segments().get(n).bits(), k, n + 1, slice);
      }
      sink.accept(k, slice);
    }
  }

  @Override
  public void readLayers(SliceSink sink) throws VolumeFormatException {
    VoxelSlice slice = MemoryCheck.slice(volume.grid(), true, sourceName());
    for (int k = 0; k < volume.grid().sizeZ(); k++) {
      boolean empty = true;
      for (int n = 0; n < volume.segments().size(); n++) {
        if (paint(volume.segments().get(n).bits(), k, n + 1, slice)) {
          sink.accept(k, slice);
          Arrays.fill(slice.integers(), 0);
          empty = false;
        }
      }
      if (empty) {
        sink.accept(k, slice);
      }
    }
  }

  /** Paints a slice of a segment and returns whether it has a voxel there. */
  private static boolean paint(BitCube bits, int k, int label, VoxelSlice slice) {
    boolean painted = false;
    for (int brickY = 0; brickY < bits.bricksY(); brickY++) {
      for (int brickX = 0; brickX < bits.bricksX(); brickX++) {
        long word = bits.brick(brickX, brickY, k >> BitCube.BRICK_SHIFT);
        long layer = word >>> BitCube.bit(0, 0, k) & 0xffff;
        for (long rest = layer; rest != 0; rest &= rest - 1) {
          int bit = Long.numberOfTrailingZeros(rest);
          int i = (brickX << BitCube.BRICK_SHIFT) + (bit & 3);
          int j = (brickY << BitCube.BRICK_SHIFT) + (bit >> 2);
          slice.integers()[j * slice.sizeX() + i] = label;
        }
        painted |= layer != 0;
      }
    }
    return painted;
  }

  @Override
  public String sourceName() {
    return name;
  }

  @Override
  public List<Path> files() {
    return files;
  }
}
