package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

class NamedSegmentTest {
  private static SegmentedVolume volume(int count) {
    List<Segment> segments =
        IntStream.rangeClosed(1, count)
            .mapToObj(n -> new Segment("s" + n, new BitCube(2, 2, 2), n))
            .toList();
    return new SegmentedVolume(VoxelGrid.ofUnitVoxels(2, 2, 2), segments);
  }

  private static void refuses(String remedy, int count) {
    Given.refuses(
        "there is no such segment: --protect bone:2: " + remedy,
        () -> NamedSegment.of(volume(count), "--protect ", "bone:2", "bone"));
  }

  @Test
  void aSegmentIsFoundByItsName() {
    SegmentedVolume volume = volume(3);
    assertSame(volume.segments().get(1), NamedSegment.of(volume, "--fixed ", "s2", "s2"));
    assertEquals(List.of(), NamedSegment.find(volume, "s4").stream().toList());
  }

  @Test
  void aRefusalSaysWhichSegmentsThereAre() {
    refuses("the volume has no segment; choose one with --segment", 0);
    refuses("choose s1", 1);
    refuses("choose s1 or s2 or s3 or s4 or s5 or s6 or s7 or s8", 8);
    refuses("choose one of the 9 segments that palpate info lists", 9);
  }
}
