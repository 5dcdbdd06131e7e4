package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.LongFunction;
import java.util.function.ToDoubleFunction;
import org.palpate.fracture.PairReadings;
import org.palpate.fracture.fit.FaceFit;
import org.palpate.geometry.Pose;
import org.palpate.reduction.GuidedPlacement.Result;
import org.palpate.volume.BitCube;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/**
 * Hands that are wrong by 1 mm and 3 degrees, or right, place the fragments of broken bones without
 * a kerf, with a guide and without. {@code -Dpalpate.fractures=N} tries N fractures of each bone.
 */
public final class GuidedHands {
  private static final int FRACTURES = Integer.getInteger("palpate.fractures", 1);

  private static final double WRONG_MM = 1;
  private static final double WRONG_DEGREES = 3;

  /** A right hand is moved by at most this. */
  private static final double RIGHT_MM = 0.1;

  private static final double RIGHT_DEGREES = 0.3;

  private final List<Result> alone = new ArrayList<>();
  private final List<Result> guided = new ArrayList<>();
  private final List<Result> right = new ArrayList<>();
  private final List<Result> rightGuided = new ArrayList<>();

  private GuidedHands() {}

  /**
   * Places the fragments of some fractures of a bone, prints how well, and checks the medians.
   *
   * @param bone its name
   * @param fracture returns the fragments of the fracture with a seed
   * @param mostMm the largest median that a guided hand that is wrong may leave
   * @param mostDegrees the same for the rotation
   */
  public static void check(
      String bone, LongFunction<Fragments> fracture, double mostMm, double mostDegrees) {
    GuidedHands hands = new GuidedHands();
    for (int seed = 1; seed <= FRACTURES; seed++) {
      hands.place(fracture.apply(seed), seed);
    }
    String text = bone + ": " + hands;
    System.out.println(text);
    assertTrue(median(hands.guided, Result::mm) <= mostMm, text);
    assertTrue(median(hands.guided, Result::degrees) <= mostDegrees, text);
    assertTrue(median(hands.rightGuided, Result::mm) <= RIGHT_MM, text);
    assertTrue(median(hands.rightGuided, Result::degrees) <= RIGHT_DEGREES, text);
  }

  private void place(Fragments fragments, long seed) {
    List<BitCube> ordered = ordered(fragments);
    for (int n = 1; n < ordered.size(); n++) {
      List<BitCube> present = ordered.subList(0, n + 1);
      GuidedPlacement placement = new GuidedPlacement(fragments.grid(), present);
      FaceFit fit = new FaceFit(fragments.grid(), present, OptionalDouble.of(0));
      long hand = 100 * seed + n;
      alone.add(placement.place(WRONG_MM, WRONG_DEGREES, hand, Optional.empty()));
      guided.add(placement.place(WRONG_MM, WRONG_DEGREES, hand, Optional.of(fit)));
      right.add(placement.place(0, 0, hand, Optional.empty()));
      rightGuided.add(placement.place(0, 0, hand, Optional.of(fit)));
    }
  }

  /** Returns the fragments such that each one faces an earlier one most. */
  private static List<BitCube> ordered(Fragments fragments) {
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
    return ordered;
  }

  private static PosedBits posed(BitCube bits, Fragments fragments) {
    return new PosedBits(bits, fragments.grid(), new Pose());
  }

  @Override
  public String toString() {
    return text("wrong", alone)
        + text("wrong, guided", guided)
        + text("right", right)
        + text("right, guided", rightGuided);
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
}
