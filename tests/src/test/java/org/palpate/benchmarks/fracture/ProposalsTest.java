package org.palpate.benchmarks.fracture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.fracture.Residual;
import org.palpate.fracture.fit.Reassembly;
import org.palpate.geometry.Pose;
import org.palpate.testing.HollowShaft;
import org.palpate.testing.Scans;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.FragmentScatter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/**
 * Puts the displaced fragments of broken bones together by proposals alone. {@code
 * -Dpalpate.proposals=1..5} tries the seeds 1 to 5 of all bones, and prints a table.
 */
class ProposalsTest {
  private static final String SEEDS = "palpate.proposals";
  private static final int PARTS = 4;
  private static final double LEAST_SHARE = 0.85;

  /** A fragment farther from its place was proposed at a wrong one. */
  private static final double WRONG_MM = 3;

  /** A search that took sharp rims alone proposed two wrong places for seed 5. */
  @ParameterizedTest
  @ValueSource(ints = {1, 5})
  void anArchWithThinWallsIsPutTogether(int seed) throws IOException {
    assertEquals(PARTS - 1, assemble("arch", seed));
  }

  @ParameterizedTest
  @ValueSource(strings = {"arch", "jaw", "shaft"})
  @EnabledIfSystemProperty(named = SEEDS, matches = "[0-9]+\\.\\.[0-9]+")
  void fracturesOfManySeedsArePutTogether(String bone) throws IOException {
    String[] range = System.getProperty(SEEDS).split("\\.\\.", 2);
    int inPlace = 0;
    int all = 0;
    for (int seed = Integer.parseInt(range[0]); seed <= Integer.parseInt(range[1]); seed++) {
      inPlace += assemble(bone, seed);
      all += PARTS - 1;
    }
    System.out.println(bone + ": " + inPlace + " of " + all + " in place");
    assertTrue(inPlace >= LEAST_SHARE * all, bone);
  }

  /** Puts a fracture together, and returns the number of fragments in place. */
  private static int assemble(String bone, int seed) throws IOException {
    Fragments fragments = fragments(bone, seed);
    List<Pose> start = FragmentScatter.scatter(fragments, seed, false);
    Reassembly reassembly =
        new Reassembly(
            Collections.nCopies(PARTS, fragments.grid()), fragments.bits(), 0, start, n -> n == 0);
    Optional<Reassembly.Joint> joint = reassembly.add();
    while (joint.isPresent()) {
      print(bone, seed, fragments, reassembly, joint.get());
      joint = reassembly.add();
    }
    return inPlace(fragments, reassembly.poses());
  }

  private static void print(
      String bone, int seed, Fragments fragments, Reassembly reassembly, Reassembly.Joint joint) {
    List<Pose> poses = reassembly.poses();
    Residual left =
        residual(fragments, joint.fragment(), poses.get(joint.fragment()), poses.get(0));
    assertTrue(
        left.distanceMm() < WRONG_MM || joint.isUncertain(),
        bone + " seed " + seed + ": " + joint + " is wrong and looks certain");
    System.out.println(
        String.format(
            Locale.ROOT,
            "%s seed %d: %d to %d, score %.0f, other place %.0f%s: %.2f mm, %.2f degrees",
            bone,
            seed,
            joint.fragment(),
            joint.other(),
            joint.scoreMm2(),
            joint.nextScoreMm2(),
            joint.isUncertain() ? ", uncertain" : "",
            left.distanceMm(),
            left.angleDegrees()));
  }

  private static int inPlace(Fragments fragments, List<Pose> poses) {
    int inPlace = 0;
    for (int n = 1; n < PARTS; n++) {
      Residual left = residual(fragments, n, poses.get(n), poses.get(0));
      inPlace +=
          left.distanceMm() <= PutBack.MOST_MM && left.angleDegrees() <= PutBack.MOST_DEGREES
              ? 1
              : 0;
    }
    return inPlace;
  }

  private static Residual residual(Fragments fragments, int n, Pose pose, Pose reference) {
    return Residual.fromRest(
        new PosedBits(fragments.bits().get(n), fragments.grid(), pose), reference);
  }

  private static Fragments fragments(String bone, int seed) throws IOException {
    BitCube bits = HollowShaft.bits();
    VoxelGrid grid = HollowShaft.GRID;
    if (!bone.equals("shaft")) {
      WholeBone whole =
          bone.equals("arch") ? WholeBone.arch() : WholeBone.jaw(Scans.file("CThead").getParent());
      bits = whole.bits();
      grid = whole.grid();
    }
    return FragmentCutter.cut(bits, grid, new FractureSpec(PARTS, seed, 0));
  }
}
