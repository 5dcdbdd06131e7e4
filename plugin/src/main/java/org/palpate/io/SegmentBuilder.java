package org.palpate.io;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Makes segments of a volume while it is read, in one pass and without keeping its values: a layer
 * of bricks, four slices high, is gathered and then stored brick by brick.
 */
public final class SegmentBuilder implements SliceSink {
  private static final VarHandle FOUR_BYTES =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  /** Brings the low bits of four bytes together in bits 24 to 27. */
  private static final int GATHER = 1 << 24 | 1 << 17 | 1 << 10 | 1 << 3;

  private static final int[] PALETTE = {
    0xE8DCC4, 0xC97B63, 0x6FA8DC, 0x93C47D, 0xF6B26B, 0x8E7CC3, 0x76A5AF, 0xC27BA0, 0xFFD966,
    0xA4C2F4
  };

  private final VoxelGrid grid;
  private final List<Part> parts = new ArrayList<>();

  /**
   * Segments by the given specs.
   *
   * @param whole whether slices will hold whole numbers, {@code header.values().whole()}
   */
  public SegmentBuilder(VoxelGrid grid, List<SegmentSpec> specs, boolean whole) {
    this.grid = grid;
    for (SegmentSpec spec : specs) {
      parts.add(new Part(spec, grid, whole, PALETTE[parts.size() % PALETTE.length]));
    }
  }

  /**
   * Reads a volume's segments.
   *
   * @throws VolumeFormatException where the volume cannot be read or its bits do not fit in memory
   */
  public static SegmentedVolume read(VolumeReader reader, List<SegmentSpec> specs)
      throws VolumeFormatException {
    VoxelGrid grid = reader.header().grid();
    Memory.require(
        bytesFor(grid, specs.size()), specs.size() + " segment(s)", reader.files().get(0));
    SegmentBuilder builder = new SegmentBuilder(grid, specs, reader.header().values().whole());
    reader.read(builder);
    return builder.build();
  }

  /** Bytes that so many segments of a grid take. */
  public static double bytesFor(VoxelGrid grid, int segments) {
    return segments * BitCube.bytesFor(grid.sizeX(), grid.sizeY(), grid.sizeZ());
  }

  @Override
  public void accept(int k, VoxelSlice slice) {
    boolean layerEnds = (k & 3) == 3 || k == grid.sizeZ() - 1;
    for (Part part : parts) {
      part.gather(k, slice);
      if (layerEnds) {
        part.store(k >> BitCube.BRICK_SHIFT);
      }
    }
  }

  /** The segments, once every slice was taken. */
  public SegmentedVolume build() {
    return new SegmentedVolume(grid, parts.stream().map(Part::segment).toList());
  }

  /** One segment and its layer of bricks. */
  private static final class Part {
    private final Segment segment;
    private final RowTest test;
    private final BitCube bits;
    private final long[] layer;
    private final byte[] inside;

    Part(SegmentSpec spec, VoxelGrid grid, boolean whole, int rgb) {
      bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
      segment = new Segment(spec.name(), bits, rgb);
      test = RowTest.of(spec.rule(), whole);
      layer = new long[bits.bricksX() * bits.bricksY()];
      inside = new byte[4 * bits.bricksX()]; // what lies beyond the row stays 0
    }

    Segment segment() {
      return segment;
    }

    void gather(int k, VoxelSlice slice) {
      for (int j = 0; j < slice.sizeY(); j++) {
        test.test(slice, j * slice.sizeX(), slice.sizeX(), inside);
        gatherRow((j >> BitCube.BRICK_SHIFT) * bits.bricksX(), BitCube.bit(0, j, k));
      }
    }

    private void gatherRow(int firstBrick, int shift) {
      for (int brick = 0; brick < bits.bricksX(); brick++) {
        int four = (int) FOUR_BYTES.get(inside, 4 * brick);
        layer[firstBrick + brick] |= (((four * GATHER) >>> 24) & 15L) << shift;
      }
    }

    void store(int brickZ) {
      for (int n = 0; n < layer.length; n++) {
        if (layer[n] != 0) {
          bits.setBrick(n % bits.bricksX(), n / bits.bricksX(), brickZ, layer[n]);
        }
      }
      Arrays.fill(layer, 0);
    }
  }
}
