package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.ToDoubleFunction;
import org.junit.jupiter.api.Test;
import org.palpate.fracture.PairReadings;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.geometry.Pose;
import org.palpate.reduction.GuidedPlacement.Result;
import org.palpate.testing.HollowShaft;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.FractureSpec;
import org.palpate.volume.fracture.FragmentCutter;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * Hands that are wrong by 1 mm and 3 degrees, or right, place the fragments of tubes and arches,
 * with a guide and without. {@code -Dpalpate.fractures=N} tries N fractures of each bone.
 */
class GuidedPlacementTest {
  private static final int FRACTURES = Integer.getInteger("palpate.fractures", 1);

  private static final int PARTS = 4;
  private static final double WRONG_MM = 1;
  private static final double WRONG_DEGREES = 3;

  /** The fragments of a bone in the order in which they are placed. */
  private record Bone(VoxelGrid grid, List<BitCube> ordered) {}

  @Test
  void aGuideLeadsAWrongHandToThePlaceInATubeAndLeavesARightOneThere() {
    check("tube", 0, 0.3, 1);
  }

  @Test
  void aGuideLeadsAWrongHandToThePlaceInAnArchAndLeavesARightOneThere() {
    check("arch", 0, 0.5, 1.5);
  }

  private static void check(String kind, int kerf, double mostMm, double mostDegrees) {
    List<Result> alone = new ArrayList<>();
    List<Result> guided = new ArrayList<>();
    List<Result> right = new ArrayList<>();
    List<Result> rightGuided = new ArrayList<>();
    for (int seed = 1; seed <= FRACTURES; seed++) {
      Bone bone = order(cut(kind, seed, kerf));
      for (int n = 1; n < PARTS; n++) {
        GuidedPlacement placement = new GuidedPlacement(bone.grid, bone.ordered.subList(0, n + 1));
        long hand = 100L * seed + n;
        alone.add(placement.place(WRONG_MM, WRONG_DEGREES, hand, Optional.empty()));
        guided.add(placement.place(WRONG_MM, WRONG_DEGREES, hand, fit(bone, n, kerf)));
        right.add(placement.place(0, 0, hand, Optional.empty()));
        rightGuided.add(placement.place(0, 0, hand, fit(bone, n, kerf)));
      }
    }
    String text =
        kind
            + ", kerf "
            + kerf
            + ": "
            + text("wrong", alone)
            + text("wrong, guided", guided)
            + text("right", right)
            + text("right, guided", rightGuided);
    System.out.println(text);
    assertTrue(median(guided, Result::mm) <= mostMm, text);
    assertTrue(median(guided, Result::degrees) <= mostDegrees, text);
    assertTrue(median(rightGuided, Result::mm) <= 0.1, text);
    assertTrue(median(rightGuided, Result::degrees) <= 0.4, text);
  }

  private static Optional<FaceFit> fit(Bone bone, int last, int kerf) {
    return Optional.of(
        new FaceFit(bone.grid, bone.ordered.subList(0, last + 1), OptionalDouble.of(kerf)));
  }

  private static String text(String name, List<Result> results) {
    return String.format(
        Locale.ROOT,
        "%n  %-14s %d fragments, median %.3f mm %.2f deg, largest %.3f mm %.2f deg, step %.4f N",
        name,
        results.size(),
        median(results, Result::mm),
        median(results, Result::degrees),
        results.stream().mapToDouble(Result::mm).max().orElse(0),
        results.stream().mapToDouble(Result::degrees).max().orElse(0),
        results.stream().mapToDouble(Result::largestStepNewton).max().orElse(0));
  }

  private static double median(List<Result> results, ToDoubleFunction<Result> value) {
    double[] sorted = results.stream().mapToDouble(value).sorted().toArray();
    return sorted[sorted.length / 2];
  }

  private static Fragments cut(String kind, int seed, int kerf) {
    FractureSpec spec = new FractureSpec(PARTS, seed, kerf);
    return kind.equals("tube")
        ? FragmentCutter.cut(HollowShaft.bits(), HollowShaft.GRID, spec)
        : new FracturePhantom(FracturePhantom.DEFAULT_EDGE, spec).fragments();
  }

  /** Returns the fragments such that each one faces an earlier one most. */
  private static Bone order(Fragments fragments) {
    List<BitCube> ordered = new ArrayList<>(List.of(fragments.bits().get(0)));
    List<BitCube> left = new ArrayList<>(fragments.bits().subList(1, fragments.bits().size()));
    while (!left.isEmpty()) {
      BitCube next = left.get(0);
      double most = -1;
      for (BitCube each : left) {
        double area = 0;
        for (BitCube placed : ordered) {
          area += PairReadings.read(posed(each, fragments), posed(placed, fragments)).facingMm2();
        }
        if (area > most) {
          most = area;
          next = each;
        }
      }
      left.remove(next);
      ordered.add(next);
    }
    return new Bone(fragments.grid(), ordered);
  }

  private static PosedBits posed(BitCube bits, Fragments fragments) {
    return new PosedBits(bits, fragments.grid(), new Pose());
  }
}
