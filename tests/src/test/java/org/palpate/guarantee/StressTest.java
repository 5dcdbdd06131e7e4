package org.palpate.guarantee;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.stress.BaselineLosses;
import org.palpate.benchmarks.stress.ExactJudge;
import org.palpate.benchmarks.stress.FailedCase;
import org.palpate.benchmarks.stress.FrameAttack;
import org.palpate.benchmarks.stress.SolverFactory;
import org.palpate.benchmarks.stress.StressRun;
import org.palpate.benchmarks.stress.StressTotals;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.raycast.Ray;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.testing.ExactOracle;
import org.palpate.testing.HostileNumbers;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class StressTest {
  private static final long LEGS = Long.getLong("palpate.stressLegs", 5_000_000);
  private static final int SIZE = 6;

  @Test
  void guardedKeepsItsPromisesUnderAttack() {
    StressTotals totals = new StressTotals();
    FailedCase failed =
        new StressRun(Seeds.seed(), GuardedSolver::new).untilLegs(totals, LEGS, now -> {});
    assertNull(failed, () -> failed.summary() + " seed " + Seeds.seed());
    System.out.println(
        "stress: "
            + totals.legs()
            + " legs in "
            + totals.frames()
            + " frames, 0 violations, seed "
            + Seeds.seed());
  }

  @Test
  void smoothKeepsItsLegsUnderAttack() {
    StressTotals totals = new StressTotals();
    FailedCase failed =
        new StressRun(Seeds.seed(), SolverFactory.SMOOTH).untilLegs(totals, LEGS / 5, now -> {});
    assertNull(failed, () -> failed.summary() + " seed " + Seeds.seed());
    System.out.println(
        "stress of smooth: " + totals.legs() + " legs in " + totals.frames() + " frames");
  }

  @Test
  void wholeFramesKeepTheirPromisesWithAFaultyDeviceAndEdits() {
    FrameAttack attack = new FrameAttack();
    String fault = attack.untilFrames(Seeds.seed(), LEGS / 10);
    assertNull(fault);
    System.out.println(
        "frames under attack: "
            + attack.legs()
            + " legs in "
            + attack.frames()
            + " frames, "
            + attack.edits()
            + " edits, set free "
            + attack.freed()
            + " times, 0 violations, seed "
            + Seeds.seed());
    assertTrue(attack.freed() > attack.frames() / 1000, "edits reach the point");
  }

  @Test
  void theJudgeAgreesWithTheRationalOracle() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    ExactJudge judge = new ExactJudge();
    Ray ray = new Ray();
    int touching = 0;
    for (int n = 0; n < 40_000; n++) {
      BitCube bits = new BitCube(SIZE, SIZE, SIZE);
      for (int solid = 0; solid < 4; solid++) {
        bits.set(random.nextInt(SIZE), random.nextInt(SIZE), random.nextInt(SIZE));
      }
      ray.from(hostile(random), hostile(random), hostile(random));
      ray.to(hostile(random), hostile(random), hostile(random));
      boolean expected = ExactOracle.touchesAny(bits, ray);
      touching += expected ? 1 : 0;
      assertEquals(expected, judge.touches(bits, ray), () -> ray + " seed " + Seeds.seed());
    }
    assertTrue(touching > 1000 && judge.exactDecisions() > 1000, "the rays are hostile enough");
  }

  private static double hostile(SplittableRandom random) {
    return HostileNumbers.coordinate(random, SIZE);
  }

  @Test
  void aFaultOfThePaperSolverIsFoundAndShrunk(@TempDir Path folder) throws IOException {
    StressTotals totals = new StressTotals();
    FailedCase failed =
        new StressRun(
                Seeds.seed(),
                (metric, maxStepMm) ->
                    new PaperSolver(
                        new SampledRayCaster(1), metric, maxStepMm, BorderVoxels.onTheFly()))
            .untilFrames(totals, 1_000_000, now -> {});
    assertNotNull(failed);
    assertTrue(failed.devices().size() <= 6, failed.summary());
    assertTrue(failed.scene().bits().solidCount() <= 12, failed.summary());
    failed.write(folder, "paper");
    assertEquals(
        failed.devices().size() + 2, Files.readAllLines(folder.resolve("device.csv")).size());
    assertTrue(Files.size(folder.resolve("scene.nrrd")) > 100);
  }

  @Test
  void aRunContinuesFromItsTotals(@TempDir Path folder) throws IOException {
    Path file = folder.resolve("totals.properties");
    StressTotals whole = new StressTotals();
    new StressRun(3, GuardedSolver::new).untilFrames(whole, 8000, now -> {});
    StressTotals first = StressTotals.read(file);
    new StressRun(3, GuardedSolver::new).untilFrames(first, 4000, now -> {});
    first.write(file);
    StressTotals second = StressTotals.read(file);
    new StressRun(3, GuardedSolver::new).untilFrames(second, 8000, now -> {});
    assertEquals(whole.legs(), second.legs());
    assertEquals(whole.frames(), second.frames());
  }

  @Test
  void baselinesLoseWhatTheExactMethodsKeep() {
    BaselineLosses losses = new BaselineLosses(Seeds.seed());
    losses.run(20);
    assertEquals(0, losses.missed("exact"));
    assertEquals(0, losses.badLegs("guarded"));
    assertTrue(losses.missed("sampled:1") > losses.missed("sampled:0.1"));
    assertTrue(losses.missed("gridplanes") > 0);
    assertTrue(losses.badLegs("paper, sampled:1") > 0);
    assertTrue(losses.badLegs("dot, sampled:1") > 0);
  }
}
