package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.GreyVolumes;
import org.palpate.io.VolumeFiles;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.BitCube;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class EditedVolumeTest {
  private static final long SEED = Long.getLong("palpate.seed", 20261128);
  private static final int SIZE = 11;

  @TempDir private Path folder;

  private final SplittableRandom random = new SplittableRandom(SEED);
  private final StringWriter said = new StringWriter();
  private final StringWriter lines = new StringWriter();
  private final WriteFailures failures = new WriteFailures(new PrintWriter(said));

  private BitCube randomBits() {
    BitCube bits = new BitCube(SIZE, SIZE, SIZE);
    for (int n = 0; n < 200; n++) {
      bits.set(random.nextInt(SIZE), random.nextInt(SIZE), random.nextInt(SIZE));
    }
    return bits;
  }

  private SegmentedVolume volume() {
    VoxelGrid grid =
        new VoxelGrid(SIZE, SIZE, SIZE, new Vec3(0.5, 2, 3), RigidTransform.identity());
    return new SegmentedVolume(
        grid, List.of(new Segment("a", randomBits(), 0), new Segment("b", randomBits(), 0)));
  }

  @Test
  void removedAndAddedVolumesAreThoseOfTheirVoxels() {
    SegmentedVolume volume = volume();
    EditedVolume edited = new EditedVolume(volume, CoordinateSystem.LPS, Optional.empty(), true);
    assertEquals(Map.of("a", 0.0, "b", 0.0), edited.carvedMm3());
    BitCube bits = volume.segments().get(0).bits();
    int removed = 0;
    int added = 0;
    for (int n = 0; n < 90; n++) {
      int i = random.nextInt(SIZE);
      int j = random.nextInt(SIZE);
      int k = n % SIZE; // never the same voxel twice in a row
      if (bits.get(i, j, k) && n % 2 == 0) {
        bits.clear(i, j, k);
        removed++;
      } else if (!bits.get(i, j, k) && n % 2 == 1) {
        bits.set(i, j, k);
        added++;
      }
    }
    double mm3 = 0.5 * 2 * 3;
    double found = (double) edited.carvedMm3().get("a");
    assertTrue(found <= removed * mm3 && found > 0, "seed=" + SEED);
    double more = (double) edited.addedMm3().get("a");
    assertEquals((added - removed) * mm3, more - found, 1e-9, "seed=" + SEED);
    assertEquals(0.0, edited.carvedMm3().get("b"));
    assertEquals(0.0, edited.addedMm3().get("b"));
  }

  @Test
  void withoutACopyNothingIsMeasured() {
    EditedVolume edited = new EditedVolume(volume(), CoordinateSystem.LPS, Optional.empty(), false);
    assertEquals(Map.of(), edited.carvedMm3());
    edited.write(failures, new PrintWriter(lines));
    assertEquals(0, failures.exitCode());
  }

  @Test
  void theTargetOfAnExportIsCheckedFirst() throws IOException {
    assertEquals(Optional.empty(), EditedVolume.checkedExport(null, List.of()));
    Path target = folder.resolve("e.nrrd");
    assertEquals(Optional.of(target), EditedVolume.checkedExport(target, List.of()));
    assertThrows(
        VolumeFormatException.class,
        () -> EditedVolume.checkedExport(folder.resolve("e.xyz"), List.of()));
    Files.writeString(target, "");
    assertTrue(
        assertThrows(
                RuntimeException.class, () -> EditedVolume.checkedExport(target, List.of(target)))
            .getMessage()
            .startsWith("the target is an input: --export " + target));
  }

  @Test
  void anExportHoldsTheVoxelsAsTheyAreNow() throws IOException {
    SegmentedVolume volume = volume();
    Path target = folder.resolve("e.nrrd");
    EditedVolume edited = new EditedVolume(volume, CoordinateSystem.LPS, Optional.of(target), true);
    BitCube bits = volume.segments().get(1).bits();
    bits.set(3, 4, 5);
    bits.clear(6, 7, 8);
    edited.write(failures, new PrintWriter(lines));
    assertEquals("", said.toString());
    assertEquals("written: " + target + ": NRRD, gzip", lines.toString().strip());
    VolumeReader reader = VolumeFiles.open(target, ReadOptions.defaults());
    assertEquals(volume.grid().spacingMm().toString(), "" + reader.header().grid().spacingMm());
    ScalarVolume labels = GreyVolumes.read(reader);
    for (int at = 0; at < SIZE * SIZE * SIZE; at++) {
      int i = at % SIZE;
      int j = at / SIZE % SIZE;
      int k = at / SIZE / SIZE;
      boolean first = volume.segments().get(0).bits().get(i, j, k);
      int expected = bits.get(i, j, k) ? 2 : first ? 1 : 0;
      assertEquals(expected, labels.value(i, j, k), i + "," + j + "," + k + " seed=" + SEED);
    }
  }

  @Test
  void anExportThatFailsIsPrinted() {
    Path target = folder.resolve("none").resolve("e.nrrd");
    new EditedVolume(volume(), CoordinateSystem.LPS, Optional.of(target), false)
        .write(failures, new PrintWriter(lines));
    assertEquals("", lines.toString());
    assertEquals(1, failures.exitCode());
    assertTrue(said.toString().contains(target.toString()), said.toString());
  }
}
