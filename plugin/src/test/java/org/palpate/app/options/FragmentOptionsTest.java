package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.Fragments;

class FragmentOptionsTest {
  private static final Path FILE = Path.of("f.nrrd");
  private static final VoxelGrid GRID = VoxelGrid.ofUnitVoxels(24, 16, 16);

  private static FragmentOptions options(String... arguments) {
    return Given.options(new FragmentOptions(), arguments);
  }

  private static Fragments make(List<Segment> segments, String... arguments) {
    return options(arguments).make(segments, GRID, "scan.nrrd");
  }

  /**
   * Returns a segment of boxes, each given by its first and last voxel along x; 8 high and deep.
   */
  private static Segment bars(int... ends) {
    BitCube bits = new BitCube(24, 16, 16);
    for (int n = 0; n < ends.length; n += 2) {
      for (int i = ends[n]; i <= ends[n + 1]; i++) {
        for (int at = 0; at < 64; at++) {
          bits.set(i, 4 + at % 8, 4 + at / 8);
        }
      }
    }
    return new Segment("bone", bits, 0xFFFFFF);
  }

  private static List<Long> sizes(Fragments fragments) {
    return fragments.segments().segments().stream()
        .map(segment -> segment.bits().solidCount())
        .toList();
  }

  @Test
  void withoutAnOptionNothingIsWantedOrChecked() {
    options().checkText();
    options().check(null);
    assertFalse(options().isWanted());
    assertFalse(options().isFracture());
  }

  @ParameterizedTest
  @CsvSource({"4, 4, 1, 1", "2:77, 2, 77, 1", "8:0:0, 8, 0, 0", "3:5:4, 3, 5, 4"})
  void aFractureHasPartsASeedAndAKerf(String text, int parts, long seed, int kerf) {
    FragmentOptions options = options("--fracture=" + text);
    options.checkText();
    options.check(FILE);
    assertTrue(options.isWanted() && options.isFracture());
    assertEquals(new FractureSpec(parts, seed, kerf), options.spec());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "1|number of fragments out of range: --fracture 1: choose 2 to 8",
        "9|number of fragments out of range: --fracture 9: choose 2 to 8",
        "4:1:5|saw kerf out of range: --fracture 4:1:5: choose 0 to 4 voxels",
        "4:1:1:1|fracture not understood: --fracture 4:1:1:1: write PARTS[:SEED[:KERF]], for"
            + " example 4:7:1",
        "four|fracture not understood: --fracture four: write PARTS[:SEED[:KERF]], for example"
            + " 4:7:1",
        "4:-1|fracture not understood: --fracture 4:-1: write PARTS[:SEED[:KERF]], for example"
            + " 4:7:1"
      })
  void aFractureOutOfRangeIsRefused(String text, String line) {
    Given.refuses(line, options("--fracture=" + text)::checkText);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "halves",
        "components:",
        "components:1:7",
        "components:-5",
        "plane:1,2,3",
        "plane:"
      })
  void aSplitOfAnotherFormIsRefused(String text) {
    Given.refuses(
        "the split is not understood: --split "
            + text
            + ": write components, components:500, components:500:6 or plane:X,Y,Z,NX,NY,NZ",
        options("--split=" + text)::checkText);
  }

  @Test
  void fragmentsNeedAFileAndOneWay() {
    Given.refuses(
        "the fragments have no file: --fracture 4: add --export FILE",
        () -> options("--fracture=4").check(null));
    Given.refuses(
        "the fragments have no file: --split components: add --export FILE",
        () -> options("--split=components").check(null));
    Given.refuses(
        "a segment is either broken or split: --fracture 4 with --split: leave one of them out",
        () -> options("--fracture=4", "--split=components").check(FILE));
  }

  @Test
  void exactlyOneSegmentIsDivided() {
    Segment bone = bars(2, 20);
    Given.refuses(
        "a fracture needs one segment, and there are 2: scan.nrrd: choose one with --segment"
            + " NAME=SPEC",
        () -> make(List.of(bone, bone), "--fracture=2"));
    Given.refuses(
        "a split needs one segment, and there are 0: scan.nrrd: choose one with --segment"
            + " NAME=SPEC",
        () -> make(List.of(), "--split=components"));
  }

  @Test
  void componentsAreThePartsThatAreLargeEnough() {
    Segment three = bars(1, 6, 10, 12, 15, 15);
    assertEquals(List.of(384L, 192L, 64L), sizes(make(List.of(three), "--split=components")));
    assertEquals(List.of(384L, 192L), sizes(make(List.of(three), "--split=components:65")));
    assertEquals(List.of(384L, 192L), sizes(make(List.of(three), "--split=components:192")));
  }

  @Test
  void componentsThatShareAnEdgeAreOneUnlessFacesAreAskedFor() {
    BitCube bits = new BitCube(24, 16, 16);
    bits.set(3, 3, 3);
    bits.set(4, 4, 3);
    bits.set(5, 5, 4);
    List<Segment> chain = List.of(new Segment("bone", bits, 0));
    assertEquals(List.of(1L, 1L, 1L), sizes(make(chain, "--split=components:1:6")));
    assertEquals(List.of(3L), sizes(make(chain, "--split=components:1:26")));
    assertEquals(List.of(3L), sizes(make(chain, "--split=components:3")));
    Given.refuses(
        "unusable number of components: 0 of at least 4 voxels: choose another least size, so that"
            + " there are 1 to 254",
        () -> make(chain, "--split=components:4"));
  }

  @Test
  void aPlaneDividesTheVoxelsByTheirCentres() {
    Segment bar = bars(2, 11);
    assertEquals(List.of(384L, 256L), sizes(make(List.of(bar), "--split=plane:8,0,0,1,0,0")));
    Given.refuses(
        "the plane does not cut the segment: all voxels lie on one side: choose a point inside",
        () -> make(List.of(bar), "--split=plane:1.9,0,0,1,0,0"));
  }

  @Test
  void aFractureIsTheOneOfItsSeed() {
    Segment bone = bars(1, 22);
    List<Long> once = sizes(make(List.of(bone), "--fracture=2:5"));
    assertEquals(2, once.size());
    assertEquals(once, sizes(make(List.of(bone), "--fracture=2:5:1")));
    long whole = bone.bits().solidCount();
    assertTrue(once.get(0) + once.get(1) < whole, "a saw takes voxels away");
    List<Long> kerfless = sizes(make(List.of(bone), "--fracture=2:5:0"));
    assertEquals(whole, kerfless.get(0) + kerfless.get(1));
  }
}
