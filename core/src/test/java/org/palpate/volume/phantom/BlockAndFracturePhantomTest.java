package org.palpate.volume.phantom;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.Fragments;

class BlockAndFracturePhantomTest {
  /** An edge of 16 units: the block is 3 to 13, 3 to 13, 3 to 11, the slab 1 to 15 and 1 to 3. */
  @Test
  void aBlockStandsOnASlab() {
    SegmentedVolume volume = Phantom.parse("block:64").segments();
    assertEquals(List.of("block", "base"), volume.segments().stream().map(s -> s.name()).toList());
    BitCube block = volume.segments().get(0).bits();
    BitCube base = volume.segments().get(1).bits();
    for (int n = 0; n < 64 * 64 * 64; n++) {
      int i = n % 64;
      int j = n / 64 % 64;
      int k = n / 4096;
      assertEquals(isIn(i, 12, 52) && isIn(j, 12, 52) && isIn(k, 12, 44), block.get(i, j, k));
      assertEquals(isIn(i, 4, 60) && isIn(j, 4, 60) && isIn(k, 4, 12), base.get(i, j, k));
    }
  }

  private static boolean isIn(int voxel, int low, int end) {
    return voxel >= low && voxel < end;
  }

  @Test
  void theGreyValuesOfABlockAreFullInBothAndHaveOneThreshold() {
    Phantom grey = Phantom.parse("block:32:grey");
    int[] counts = new int[3];
    short[] slice = new short[32 * 32];
    PhantomSlices slices = grey.slices();
    for (int k = 0; k < 32; k++) {
      slices.read(k, slice);
      for (short value : slice) {
        counts[value == 0 ? 0 : value == Phantom.SOLID_GREY ? 1 : 2]++;
      }
    }
    assertEquals(0, counts[2], "the faces lie between voxels");
    assertEquals(20 * 20 * 16 + 28 * 28 * 4, counts[1]);
    assertEquals(List.of(new Phantom.Threshold("block", Phantom.HALF_GREY)), grey.thresholds());
    assertEquals(
        List.of("bone", "head"),
        Phantom.parse("head:64:grey").thresholds().stream().map(t -> t.name()).toList());
  }

  @Test
  void aFractureIsReadAndWrittenAsText() {
    FracturePhantom phantom = FracturePhantom.parse("fracture:96:5:7:2");
    assertEquals(96, phantom.edge());
    assertEquals(new FractureSpec(5, 7, 2), phantom.fracture());
    assertEquals("fracture:96:5:7:2", phantom.spec());
    assertEquals(phantom, FracturePhantom.parse(phantom.spec()));
    FracturePhantom usual = FracturePhantom.parse("fracture");
    assertEquals(FracturePhantom.DEFAULT_EDGE, usual.edge());
    assertEquals(FracturePhantom.DEFAULT_PARTS, usual.fracture().parts());
    assertEquals(
        FractureSpec.DEFAULT_KERF, FracturePhantom.parse("fracture:70").fracture().kerfVoxels());
  }

  @Test
  void onlyItsOwnNameIsAccepted() {
    assertTrue(FracturePhantom.accepts("fracture"));
    assertTrue(FracturePhantom.accepts("fracture:64:3"));
    assertFalse(FracturePhantom.accepts("fractured"));
    assertFalse(FracturePhantom.accepts("head:64"));
  }

  @Test
  void aTextOfAnotherFormAndAnEdgeOutOfRangeAreRefused() {
    assertEquals(
        "phantom edge is not a number: fracture:x: write fracture[:EDGE[:PARTS[:SEED[:KERF]]]]",
        refusal("fracture:x"));
    assertEquals("phantom edge out of range: edge=63: choose 64 to 1024", refusal("fracture:63"));
    assertEquals(
        "phantom edge out of range: edge=1025: choose 64 to 1024", refusal("fracture:1025"));
    for (String wrong :
        List.of(
            "fracture:64:4:1:1:1", "fracture:64:x", "fracture:64:4:-1", "fracture:64:1234567890")) {
      assertEquals(
          "phantom fracture not understood: "
              + wrong
              + ": write fracture[:EDGE[:PARTS[:SEED[:KERF]]]], for example fracture:160:4:7:1",
          refusal(wrong));
    }
    assertEquals(64, FracturePhantom.parse("fracture:64").edge());
    assertEquals(1024, FracturePhantom.parse("fracture:1024").edge());
  }

  private static String refusal(String spec) {
    return assertThrows(IllegalArgumentException.class, () -> FracturePhantom.parse(spec))
        .getMessage();
  }

  @Test
  void theFragmentsOfAJawAreDisplacedExceptTheLargest() {
    FracturePhantom phantom = FracturePhantom.parse("fracture:96:3:2");
    Fragments fragments = phantom.fragments();
    assertEquals(3, fragments.bits().size());
    assertEquals(96, phantom.grid().sizeX());
    long kept = fragments.bits().stream().mapToLong(BitCube::solidCount).sum();
    assertEquals(phantom.bone().solidCount(), kept + fragments.lostVoxels());
    List<Pose> starts = phantom.startPoses(fragments);
    assertEquals(3, starts.size());
    assertTrue(starts.get(0).sameBits(new Pose()));
    Vec3 middle = new Vec3(48, 48, 48);
    for (int n = 1; n < 3; n++) {
      double moved = starts.get(n).transform(middle, new Vec3()).sub(middle, new Vec3()).length();
      assertTrue(moved > 1, "fragment " + (n + 1) + " moved by " + moved);
    }
  }

  /** An arch is symmetric, has a hollow inside that its wall encloses, and is one piece. */
  @Test
  void aJawIsASymmetricArchWithMarrow() {
    BitCube bone = JawArch.bone(96);
    assertEquals(1, ConnectedComponents.of(bone, Neighbours.FACES_EDGES_CORNERS, 1).size());
    int differing = 0;
    for (int n = 0; n < 96 * 96 * 96; n++) {
      int i = n % 96;
      int j = n / 96 % 96;
      int k = n / 9216;
      differing += bone.get(i, j, k) == bone.get(95 - i, j, k) ? 0 : 1;
    }
    assertTrue(differing < bone.solidCount() / 50, differing + " of " + bone.solidCount());
    assertTrue(bone.bounds().lowX > 4 && bone.bounds().highX < 92, bone.bounds().toString());
    int hollow = 0;
    for (int k = 0; k < 96; k++) {
      hollow += crossings(bone, k) >= 4 ? 1 : 0;
    }
    assertTrue(hollow > 5, "slices with marrow between two walls: " + hollow);
  }

  /** Returns the most walls that a line along y meets in a slice. */
  private static int crossings(BitCube bone, int k) {
    int most = 0;
    for (int i = 0; i < 96; i++) {
      int changes = 0;
      for (int j = 1; j < 96; j++) {
        changes += bone.get(i, j, k) == bone.get(i, j - 1, k) ? 0 : 1;
      }
      most = Math.max(most, changes);
    }
    return most;
  }
}
