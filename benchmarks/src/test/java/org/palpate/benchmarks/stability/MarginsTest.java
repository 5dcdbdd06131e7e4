package org.palpate.benchmarks.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.Row;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;
import org.palpate.geometry.Vec3;

class MarginsTest {
  private static Outcome outcome(boolean stable) {
    return new Outcome(stable, 0, 0, 0);
  }

  @Test
  void theSearchEndsBelowTheTrueLimitByAtMostItsResolution() {
    double resolution = Math.pow(2, 1 / 32.0);
    for (double limit = 60; limit < 150_000; limit *= 1.37) {
      double limitOfTrial = limit;
      double found = StiffnessSearch.largest(k -> outcome(k <= limitOfTrial));
      assertTrue(found <= limit, "found=" + found + " limit=" + limit);
      assertTrue(found * resolution * (1 + 1e-12) > limit, "found=" + found + " limit=" + limit);
    }
  }

  @Test
  void theSearchReportsThatNothingOrEverythingIsStable() {
    assertEquals(0, StiffnessSearch.largest(k -> outcome(false)));
    assertEquals(Double.POSITIVE_INFINITY, StiffnessSearch.largest(k -> outcome(true)));
    assertEquals(0, StiffnessSearch.largest(k -> outcome(k < StiffnessSearch.SOFTEST)));
  }

  @Test
  void theSearchTriesNothingBeyondTheStiffestAndNothingTwice() {
    List<Double> tried = new ArrayList<>();
    StiffnessSearch.largest(
        k -> {
          tried.add(k);
          return outcome(k <= 1_000);
        });
    assertEquals(tried.size(), tried.stream().distinct().count());
    assertEquals(6 + 5, tried.size(), "50 to 1,600, and five halvings");
    tried.clear();
    StiffnessSearch.largest(
        k -> {
          tried.add(k);
          return outcome(true);
        });
    assertTrue(tried.stream().allMatch(k -> k <= StiffnessSearch.STIFFEST), tried.toString());
  }

  @Test
  void anExcursionIsTheDiagonalOfTheBoxOfAllMotionInItsInterval() {
    HandleExcursion excursion = new HandleExcursion(1, 2, 3);
    excursion.record(1, new double[] {9, 9, 9}); // not yet
    excursion.record(1.1, new double[] {0.001, 0.005, -0.002});
    excursion.record(1.5, new double[] {0.004, 0.001, -0.002});
    excursion.record(2, new double[] {0.003, 0.002, 0.010});
    excursion.record(2.01, new double[] {9, 9, 9}); // too late
    assertEquals(Math.sqrt(9 + 16 + 144), excursion.excursionMm(), 1e-12);
  }

  @Test
  void aRotationCountsAtTheRadiusOfTheGrip() {
    HandleExcursion excursion = new HandleExcursion(0, 1, 6);
    excursion.record(0.5, new double[] {0, 0, 0, 0.1, 0, 0});
    excursion.record(0.6, new double[] {0, 0, 0, -0.1, 0, 0});
    assertEquals(0.2 * Grip.RADIUS_MM, excursion.excursionMm(), 1e-12);
  }

  @Test
  void aHandleThatSinksComesBackOnlyFromItsDeepestPosition() {
    HandleRebound rebound = new HandleRebound(1, 2, new Vec3(0, 0, -1));
    assertEquals(Double.POSITIVE_INFINITY, rebound.longestMm());
    rebound.record(1, new double[] {0, 0, -9}); // not yet
    double[] heightsMm = {5, 4, 4.5, 3, 3.2, 3.4, 3, 1};
    for (int n = 0; n < heightsMm.length; n++) {
      rebound.record(1.1 + 0.1 * n, new double[] {n, 7, heightsMm[n] * 1e-3});
    }
    rebound.record(2.01, new double[] {0, 0, 9}); // too late
    assertEquals(0.5, rebound.longestMm(), 1e-12);
  }

  @Test
  void aHandleThatWasNeverSeenAtRestIsNotAtRest() {
    HandleExcursion excursion = new HandleExcursion(1, 2, 3);
    excursion.record(3, new double[] {0, 0, 0});
    assertEquals(Double.POSITIVE_INFINITY, excursion.excursionMm());
  }

  @Test
  void theRowOfTheTheoryFollowsItsColumns() {
    assertEquals(
        Map.of(
            "rate_hz",
            1_000.0,
            "delay_samples",
            2,
            "damping_ns_per_m",
            0.5,
            "largest_n_per_m",
            190.0,
            "passive_n_per_m",
            200.0),
        Row.of(
            StudyTable.STABILITY_THEORY,
            new TheoryRow(new Sampling(1_000, 2), 0.5, 190, 200).cells()));
  }

  @Test
  void aMarginOfADeviceWhoseStiffestIsStableIsInfinite() {
    Trial trial =
        new Trial(
            DeviceModel.KNOWN.get(0),
            Grip.FIRM,
            new Sampling(1_000, 1),
            TouchedShape.wall(),
            StabilityStudy.GUARDED,
            false);
    double infinity = Double.POSITIVE_INFINITY;
    assertEquals(infinity, new MarginRow<>(trial, 200, infinity, outcome(true)).margin());
    assertEquals(1.5, new MarginRow<>(trial, 200, 300, outcome(true)).margin());
    List<MarginRow<Trial>> rows =
        List.of(
            new MarginRow<>(trial, 200, 500, outcome(true)),
            new MarginRow<>(trial, 200, 300, outcome(true)),
            new MarginRow<>(trial, 200, infinity, outcome(true)));
    assertEquals(Map.of(trial.device().name(), 1.5), StabilityStudy.leastMargins(rows));
  }

  private static double givenMillijoule(String name) {
    FeelTrial.Feel feel =
        FeelTrial.feels().stream().filter(one -> one.name().equals(name)).findFirst().orElseThrow();
    DeviceModel device = DeviceModel.KNOWN.get(0);
    double newtonPerM = 500 * device.maxStiffnessNewtonPerMm();
    return new FeelTrial(device, Grip.FIRM, new Sampling(1_000, 1), feel)
        .givenMillijoule(newtonPerM);
  }

  @Test
  void plainContactGivesNoEnergyAndLiquidAndMassTakeSome() {
    assertEquals(0, givenMillijoule("none"), 0.01);
    assertTrue(givenMillijoule("viscosity 0.01") < -0.5);
    assertTrue(givenMillijoule("mass 0.05 kg") < -0.1);
  }

  @Test
  void aFrameLastsAsLongAsItsRateSays() {
    assertEquals(1_000_000, new Sampling(1_000, 0).periodNanos());
    assertEquals(333_333, new Sampling(3_000, 0).periodNanos());
    assertEquals(666_667, new Sampling(1_500, 0).periodNanos());
  }
}
