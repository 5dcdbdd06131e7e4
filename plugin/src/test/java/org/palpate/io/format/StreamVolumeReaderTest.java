package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeHeader;
import org.palpate.io.volume.VolumeHeader.ValueRange;
import org.palpate.io.volume.VoxelType;
import org.palpate.volume.VoxelGrid;

class StreamVolumeReaderTest {
  private static final int[] SIZES = {3, 2, 4};
  private static final VolumeHeader HEADER =
      new VolumeHeader(
          "test",
          VoxelGrid.ofUnitVoxels(3, 2, 4),
          VoxelType.UINT8,
          ValueRange.of(VoxelType.UINT8),
          CoordinateSystem.UNKNOWN,
          Optional.empty(),
          List.of());

  private static StreamVolumeReader reader(byte[] bytes, NonSpatialAxis extra, List<String> done) {
    return new StreamVolumeReader(
        HEADER,
        List.of(Path.of("v.raw"), Path.of("w.raw")),
        () ->
            new BinarySampleStream(
                new ByteArrayInputStream(bytes),
                VoxelType.UINT8,
                ByteOrder.LITTLE_ENDIAN,
                Scaling.NONE),
        extra,
        (slices, all) -> done.add(slices + " of " + all));
  }

  /** Returns the value of a voxel at a step. */
  private static int value(int i, int j, int k, int step) {
    return i + 4 * j + 10 * k + 50 * step;
  }

  /** Writes a volume with an axis of time behind some of its axes of space. */
  private static byte[] written(int position, int count) {
    int[] sizes = new int[4];
    int at = 0;
    for (int axis = 0; axis < 4; axis++) {
      sizes[axis] = axis == position ? count : SIZES[at++];
    }
    byte[] bytes = new byte[sizes[0] * sizes[1] * sizes[2] * sizes[3]];
    int[] index = new int[4];
    for (int n = 0; n < bytes.length; n++) {
      int rest = n;
      for (int axis = 0; axis < 4; axis++) {
        index[axis] = rest % sizes[axis];
        rest /= sizes[axis];
      }
      int[] voxel = new int[3];
      at = 0;
      for (int axis = 0; axis < 4; axis++) {
        if (axis != position) {
          voxel[at++] = index[axis];
        }
      }
      bytes[n] = (byte) value(voxel[0], voxel[1], voxel[2], index[position]);
    }
    return bytes;
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "0, 2", "1, 1", "2, 0", "2, 2", "3, 0", "3, 1", "3, 2"})
  void oneStepIsReadWhereverItsAxisStands(int position, int step) throws IOException {
    NonSpatialAxis extra = new NonSpatialAxis(position, 3, step);
    List<String> done = new ArrayList<>();
    StreamVolumeReader reader = reader(written(position, 3), extra, done);
    for (int pass = 0; pass < 2; pass++) {
      List<Integer> slices = new ArrayList<>();
      reader.read(
          (k, slice) -> {
            slices.add(k);
            for (int n = 0; n < slice.count(); n++) {
              assertEquals(value(n % 3, n / 3, k, step), slice.integers()[n], k + " " + n);
            }
          });
      assertEquals(List.of(0, 1, 2, 3), slices);
    }
    assertEquals(List.of("1 of 4", "2 of 4", "3 of 4", "4 of 4"), done.subList(4, 8));
  }

  @Test
  void theFirstFileNamesTheVolume() {
    StreamVolumeReader reader = reader(new byte[0], NonSpatialAxis.NONE, new ArrayList<>());
    assertEquals("v.raw", reader.sourceName());
    assertEquals(2, reader.files().size());
    assertEquals(HEADER, reader.header());
  }

  @Test
  void theSliceAtWhichTheDataEndIsNamed() {
    List<String> done = new ArrayList<>();
    VolumeFormatException refusal =
        assertThrows(
            VolumeFormatException.class,
            () -> reader(new byte[17], NonSpatialAxis.NONE, done).read((k, slice) -> {}));
    assertEquals(
        "the data end after 2 of 4 slices: v.raw: copy the file again", refusal.getMessage());
    assertEquals(List.of("1 of 4", "2 of 4"), done);
  }

  @Test
  void aDamagedSliceIsNamedWithItsReason() {
    StreamVolumeReader reader = reader(new byte[24], NonSpatialAxis.NONE, new ArrayList<>());
    VolumeFormatException damaged =
        assertThrows(
            VolumeFormatException.class,
            () ->
                SliceLoop.read(
                    reader,
                    (slices, all) -> {},
                    () -> () -> {},
                    (source, k) -> {
                      if (k == 3) {
                        throw new IOException("bad block");
                      }
                    }));
    assertEquals(
        "the data are damaged in slice 3 (bad block): v.raw: copy or export the file again",
        damaged.getMessage());
  }

  @Test
  void aFailureToWriteIsNoFailureToRead() {
    StreamVolumeReader reader = reader(new byte[24], NonSpatialAxis.NONE, new ArrayList<>());
    IOException full =
        assertThrows(
            IOException.class,
            () ->
                SliceWriter.writeAll(
                    reader::read,
                    (k, slice) -> {
                      throw new IOException("disk full");
                    }));
    assertEquals("disk full", full.getMessage());
  }
}
