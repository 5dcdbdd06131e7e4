package org.palpate.volume;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.ScalarVolume.Storage;

class SegmentedVolumeTest {
  private static final VoxelGrid GRID = grid(1.5);
  private static final VoxelGrid FINE = grid(0.4);

  private final Segment bone = new Segment("bone", new BitCube(4, 5, 6), 1);
  private final Segment skin = new Segment("skin", new BitCube(4, 5, 6), 2);

  private static VoxelGrid grid(double edge) {
    return new VoxelGrid(4, 5, 6, new Vec3(2, edge, 3), RigidTransform.identity());
  }

  @Test
  void segmentsOfOneFileShareItsGrid() {
    SegmentedVolume volume = new SegmentedVolume(GRID, List.of(bone, skin));
    assertTrue(volume.hasOneGrid());
    assertSame(GRID, volume.grid(1));
    assertSame(GRID, volume.gridOf(skin));
    assertEquals(1.5, volume.shortestEdgeMm());
  }

  @Test
  void bodiesOfOtherFilesHaveGridsOfTheirOwn() {
    SegmentedVolume volume = new SegmentedVolume(GRID, List.of(bone, skin), List.of(GRID, FINE));
    assertFalse(volume.hasOneGrid());
    assertSame(GRID, volume.gridOf(bone));
    assertSame(FINE, volume.gridOf(skin));
    assertSame(FINE, volume.grid(1));
    assertEquals(0.4, volume.shortestEdgeMm());
  }

  @Test
  void eachSegmentNeedsAGrid() {
    IllegalArgumentException refused =
        assertThrows(
            IllegalArgumentException.class,
            () -> new SegmentedVolume(GRID, List.of(bone, skin), List.of(GRID)));
    assertEquals("each segment has a grid: grids=1, segments=2", refused.getMessage());
  }

  @Test
  void aVolumeKeepsCopiesOfItsLists() {
    List<Segment> segments = new ArrayList<>(List.of(bone));
    SegmentedVolume volume = new SegmentedVolume(GRID, segments);
    segments.add(skin);
    assertEquals(List.of(bone), volume.segments());
  }

  @Test
  void aGridKnowsItsMetric() {
    assertEquals(2, GRID.metric().spacingX());
    assertEquals(1.5, GRID.metric().spacingY());
    assertEquals(3, GRID.metric().spacingZ());
  }

  @Test
  void valuesTakeAsManyBytesAsTheirStorageSays() {
    assertEquals(4 * 5 * 6, ScalarVolume.bytesFor(GRID, Storage.forIntegers(0, 255)));
    assertEquals(2 * 4 * 5 * 6, ScalarVolume.bytesFor(GRID, Storage.INT16));
    assertEquals(4 * 4 * 5 * 6, ScalarVolume.bytesFor(GRID, Storage.FLOAT32));
    VoxelGrid huge =
        new VoxelGrid(1 << 20, 1 << 20, 1 << 20, new Vec3(1, 1, 1), RigidTransform.identity());
    assertEquals(0x1p61, ScalarVolume.bytesFor(huge, Storage.UINT16), "more than an int holds");
  }

  @Test
  void integersGetTheNarrowestStorageThatHoldsThem() {
    assertEquals(1, Storage.forIntegers(0, 255).bytes());
    assertEquals(2, Storage.forIntegers(0, 256).bytes());
    assertEquals(Storage.UINT16, Storage.forIntegers(0, 40_000));
    assertEquals(Storage.INT16, Storage.forIntegers(-1, 255));
    assertEquals(Storage.INT16, Storage.forIntegers(-32_768, 32_767));
    assertEquals(Storage.FLOAT32, Storage.forIntegers(-1, 65_535));
  }

  @Test
  void aVolumeKnowsItsGridAndItsStorage() {
    ScalarVolume volume = ScalarVolume.of(GRID, Storage.INT16);
    assertSame(GRID, volume.grid());
    assertEquals(Storage.INT16, volume.storage());
  }

  @Test
  void aVoxelIsSurroundedIfAllSixBesideItAreSolid() {
    BitCube bits = new BitCube(9, 9, 9);
    int[][] beside = {{3, 4, 4}, {5, 4, 4}, {4, 3, 4}, {4, 5, 4}, {4, 4, 3}, {4, 4, 5}};
    for (int[] v : beside) {
      bits.set(v[0], v[1], v[2]);
    }
    assertTrue(bits.isSurrounded(4, 4, 4), "whatever the voxel itself is");
    for (int[] v : beside) {
      bits.clear(v[0], v[1], v[2]);
      assertFalse(bits.isSurrounded(4, 4, 4), "without " + v[0] + "," + v[1] + "," + v[2]);
      bits.set(v[0], v[1], v[2]);
    }
    BitCube full = new BitCube(3, 3, 3);
    for (int n = 0; n < 27; n++) {
      full.set(n % 3, n / 3 % 3, n / 9);
    }
    assertTrue(full.isSurrounded(1, 1, 1));
    assertFalse(full.isSurrounded(0, 1, 1), "outside the cube all is empty");
    List<String> rim = new ArrayList<>();
    full.forEachRimVoxel((i, j, k) -> rim.add(i + "" + j + k));
    assertEquals(26, rim.size());
    assertFalse(rim.contains("111"));
  }
}
