package org.palpate.io.label;

import java.lang.invoke.MethodHandles;
import java.lang.invoke.VarHandle;
import java.nio.ByteOrder;
import java.util.Arrays;
import org.palpate.io.volume.VoxelSlice;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.VoxelGrid;

/** Builds one segment: collects a layer of bricks and stores it when it is complete. */
final class SegmentAccumulator {
  private static final VarHandle FOUR_BYTES =
      MethodHandles.byteArrayViewVarHandle(int[].class, ByteOrder.LITTLE_ENDIAN);

  /** A factor that moves the low bits of four bytes together to bits 24 to 27. */
  private static final int GATHER = 1 << 24 | 1 << 17 | 1 << 10 | 1 << 3;

  private final Segment segment;
  private final RowClassifier test;
  private final BitCube bits;
  private final long[] layer;
  private final byte[] inside;
  private boolean touched;

  SegmentAccumulator(SegmentSpec spec, VoxelGrid grid, boolean integer, int rgb) {
    bits = new BitCube(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    segment = new Segment(spec.name(), bits, rgb);
    test = RowClassifier.of(spec.rule(), integer);
    layer = new long[bits.bricksX() * bits.bricksY()];
    inside = new byte[4 * bits.bricksX()]; // bytes beyond the row stay 0
  }

  /** Returns the segment. */
  Segment segment() {
    return segment;
  }

  /** Adds slice k by the segment's own rule. */
  void addSlice(int k, VoxelSlice slice) {
    touched = true;
    for (int j = 0; j < slice.sizeY(); j++) {
      test.test(slice, j * slice.sizeX(), slice.sizeX(), inside);
      addRow((j >> BitCube.BRICK_SHIFT) * bits.bricksX(), BitCube.bit(0, j, k));
    }
  }

  private void addRow(int firstBrick, int shift) {
    for (int brick = 0; brick < bits.bricksX(); brick++) {
      int four = (int) FOUR_BYTES.get(inside, 4 * brick);
      layer[firstBrick + brick] |= (((four * GATHER) >>> 24) & 15L) << shift;
    }
  }

  /** Marks one voxel of the layer as solid. */
  void mark(int i, int j, int k) {
    touched = true;
    layer[(j >> BitCube.BRICK_SHIFT) * bits.bricksX() + (i >> BitCube.BRICK_SHIFT)] |=
        1L << BitCube.bit(i, j, k);
  }

  /** Stores the layer as bricks and clears it. */
  void storeBrickLayer(int brickZ) {
    if (!touched) {
      return;
    }
    for (int n = 0; n < layer.length; n++) {
      if (layer[n] != 0) {
        bits.setBrick(n % bits.bricksX(), n / bits.bricksX(), brickZ, layer[n]);
      }
    }
    Arrays.fill(layer, 0);
    touched = false;
  }
}
