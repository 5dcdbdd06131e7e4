package org.palpate.io.nrrd;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.testing.Scans;
import org.palpate.volume.SegmentedVolume;

class NrrdReaderTest {

  @Test
  void countsOfTheRealScansAreRightToTheVoxel() throws Exception {
    // counts and box: data/README.md
    SegmentedVolume head = read("CThead/CThead_u16gz.nrrd", SegmentSpec.atLeast("bone", 1500));
    assertEquals(336_108, head.segments().get(0).bits().solidCount());
    assertEquals("x 28-195, y 25-238, z 4-112", head.segments().get(0).bits().bounds().toString());
    assertEquals(
        2_068_115,
        read("LIDC/LIDC-IDRI-0314_ge100HU_i16gz.nrrd", SegmentSpec.atLeast("bone", 200))
            .segments()
            .get(0)
            .bits()
            .solidCount());
    assertEquals(532_633, count("labels/Skull.nrrd", SegmentSpec.nonzero("all")));
    assertEquals(972_670, count("labels/HN-Atlas-labels.nrrd", SegmentSpec.nonzero("all")));
  }

  @Test
  void readsDataAtAPathThatLeavesASubFolderButNotTheFolder() throws Exception {
    VolumeReader reader =
        VolumeFiles.open(Scans.file("cases/nrrd/detached/vol.nhdr"), ReadOptions.defaults());
    long[] sum = {0};
    reader.read((k, slice) -> sum[0] += Arrays.stream(slice.integers()).sum());
    assertEquals(47_880, sum[0]);
    assertEquals(
        new Vec3(4, 5.75, 11).toString(),
        reader.header().grid().gridToWorld(new Vec3(6.5, 5.5, 4.5), new Vec3()).toString());
  }

  private static long count(String name, SegmentSpec spec) throws VolumeFormatException {
    return read(name, spec).segments().get(0).bits().solidCount();
  }

  private static SegmentedVolume read(String name, SegmentSpec spec) throws VolumeFormatException {
    VolumeReader reader = VolumeFiles.open(Scans.file(name), ReadOptions.defaults());
    return SegmentBuilder.read(reader, List.of(spec));
  }
}
