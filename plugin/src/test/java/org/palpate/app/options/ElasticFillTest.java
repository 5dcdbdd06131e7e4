package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/** A hollow box of 9 voxels, with a solid box of 3 voxels in its middle. */
class ElasticFillTest {
  private static final int EDGE = 11;

  private final BitCube shell = box(1, 9);
  private final BitCube core = box(4, 6);
  private final SegmentedVolume volume;

  ElasticFillTest() {
    for (int n = 0; n < 7 * 7 * 7; n++) {
      shell.clear(2 + n % 7, 2 + n / 7 % 7, 2 + n / 49);
    }
    volume =
        new SegmentedVolume(
            VoxelGrid.ofUnitVoxels(EDGE, EDGE, EDGE),
            List.of(new Segment("skin", shell, 1), new Segment("skull", core, 2)));
  }

  private static BitCube box(int from, int to) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int k = from; k <= to; k++) {
      for (int j = from; j <= to; j++) {
        for (int i = from; i <= to; i++) {
          bits.set(i, j, k);
        }
      }
    }
    return bits;
  }

  @Test
  void fillsTheSpaceBetweenTheTwoSegments() {
    BitCube space = ElasticFill.parse("tissue", "skin..skull").voxels(volume);
    assertEquals(7 * 7 * 7 - 3 * 3 * 3, space.solidCount());
    assertTrue(space.get(2, 2, 2) && space.get(8, 8, 8));
    assertFalse(space.get(5, 5, 5) || space.get(1, 1, 1) || space.get(0, 0, 0));
  }

  @Test
  void fitsAVolumeThatHasBothSegments() {
    assertTrue(ElasticFill.OF_HEAD.fits(volume));
    assertFalse(new ElasticFill("tissue", "skin", "jaw").fits(volume));
    assertFalse(new ElasticFill("tissue", "jaw", "skull").fits(volume));
  }

  @ParameterizedTest
  @CsvSource({"tissue, skin", "tissue, skin..", "tissue, ..skull", "' ', skin..skull"})
  void aTextThatNamesNoTwoSegmentsIsRefused(String name, String between) {
    Given.refuses(
        "a fill lies between two segments: --fill "
            + name
            + "="
            + between
            + ": write NAME=OUTER..INNER, as in tissue=skin..skull",
        () -> ElasticFill.parse(name, between));
  }

  @Test
  void aSegmentThatIsMissingIsNamed() {
    Given.refuses(
        "there is no segment jaw: --fill tissue=skin..jaw: choose skin or skull",
        () -> ElasticFill.parse("tissue", "skin..jaw").voxels(volume));
  }

  @Test
  void theNameOfASegmentIsTaken() {
    Given.refuses(
        "a segment has the name of the fill: --fill skull=skin..skull: choose another name",
        () -> ElasticFill.parse("skull", "skin..skull").voxels(volume));
  }

  @Test
  void segmentsWithNothingBetweenThemAreRefused() {
    Given.refuses(
        "there is no empty space between the segments: --fill tissue=skull..skin: leave it out",
        () -> ElasticFill.parse("tissue", "skull..skin").voxels(volume));
  }
}
