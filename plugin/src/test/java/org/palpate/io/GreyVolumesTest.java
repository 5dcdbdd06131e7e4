package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.SliceSink;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeReader;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.phantom.Phantom;

class GreyVolumesTest {
  private static final VolumeReader GREY = new PhantomReader(Phantom.parse("head:24:grey"));

  @Test
  void bitsAndGreyValuesComeFromOnePass() throws Exception {
    List<SegmentSpec> specs =
        List.of(SegmentSpec.atLeast("bone", 661), SegmentSpec.range("soft", 100, 660));
    CountedReader counted = new CountedReader(GREY, false);
    GreyVolumes.WithSegments both = GreyVolumes.readWithSegments(counted, specs);
    assertEquals(1, counted.passes);
    requireSameValues(GreyVolumes.read(GREY), both.values());
    List<Segment> apart = SegmentBuilder.read(GREY, specs).segments();
    for (int n = 0; n < specs.size(); n++) {
      requireSameBits(apart.get(n).bits(), both.segments().segments().get(n).bits());
    }
  }

  @Test
  void ofLabelsThatOverlapEachSegmentIsWholeAndTheLastValueIsKept() throws Exception {
    CountedReader layered = new CountedReader(GREY, true);
    List<SegmentSpec> specs = List.of(SegmentSpec.labels("one", 1), SegmentSpec.labels("two", 2));
    GreyVolumes.WithSegments both = GreyVolumes.readWithSegments(layered, specs);
    assertEquals(3, both.segments().segments().get(0).bits().solidCount());
    assertEquals(2, both.segments().segments().get(1).bits().solidCount());
    assertEquals(1, both.values().value(0, 0, 0));
    assertEquals(2, both.values().value(2, 0, 0), "voxel 2 is in both");
    assertEquals(2, both.values().value(3, 0, 0));
    assertEquals(0, both.values().value(4, 0, 0));
  }

  private static void requireSameValues(ScalarVolume expected, ScalarVolume found) {
    assertEquals(expected.storage(), found.storage());
    forEachVoxel(
        expected.grid(), (i, j, k) -> assertEquals(expected.value(i, j, k), found.value(i, j, k)));
  }

  private static void requireSameBits(BitCube expected, BitCube found) {
    forEachVoxel(
        GREY.header().grid(), (i, j, k) -> assertEquals(expected.get(i, j, k), found.get(i, j, k)));
  }

  private interface VoxelSink {
    void accept(int i, int j, int k);
  }

  private static void forEachVoxel(VoxelGrid grid, VoxelSink sink) {
    for (int k = 0; k < grid.sizeZ(); k++) {
      for (int j = 0; j < grid.sizeY(); j++) {
        for (int i = 0; i < grid.sizeX(); i++) {
          sink.accept(i, j, k);
        }
      }
    }
  }

  /** Counts the passes over a volume; layered, it has label 1 in voxels 0 to 2, 2 in 2 and 3. */
  private static final class CountedReader implements VolumeReader {
    private final VolumeReader volume;
    private final boolean layered;
    private int passes;

    CountedReader(VolumeReader volume, boolean layered) {
      this.volume = volume;
      this.layered = layered;
    }

    @Override
    public VolumeHeader header() {
      return volume.header();
    }

    @Override
    public void read(SliceSink sink) throws VolumeFormatException {
      passes++;
      volume.read(sink);
    }

    @Override
    public void readLayers(SliceSink sink) throws VolumeFormatException {
      if (!layered) {
        read(sink);
        return;
      }
      VoxelGrid grid = header().grid();
      for (int k = 0; k < grid.sizeZ(); k++) {
        sink.accept(k, layer(k, 0, 2, 1));
        sink.accept(k, layer(k, 2, 3, 2));
      }
    }

    private VoxelSlice layer(int k, int from, int to, int label) {
      VoxelSlice slice = new VoxelSlice(header().grid().sizeX(), header().grid().sizeY(), true);
      for (int n = from; n <= to && k == 0; n++) {
        slice.integers()[n] = label;
      }
      return slice;
    }

    @Override
    public String sourceName() {
      return volume.sourceName();
    }

    @Override
    public List<Path> files() {
      return List.of();
    }
  }
}
