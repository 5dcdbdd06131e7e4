package org.palpate.benchmarks.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

class ClosedLoopTest {
  private static final DeviceModel BARE =
      new DeviceModel("bare", 1000, 1, 0.1, 2, 1).withFineEncoder();

  @TempDir private Path folder;

  @Test
  void aBareHandleIsStableBelowTheTheorysStiffnessAndUnstableAboveIt() {
    for (int delay = 0; delay <= 2; delay++) {
      Sampling sampling = new Sampling(1000, delay);
      double passive = sampling.passiveNewtonPerM(BARE.dampingNewtonSecondPerM());
      Trial trial =
          new Trial(BARE, Grip.NONE, sampling, TouchedShape.wall(), StabilityStudy.GUARDED, false);
      assertTrue(trial.run(passive * 0.7).stable(), "delay=" + delay);
      assertFalse(trial.run(passive * 1.4).stable(), "delay=" + delay);
      double largest = StiffnessSearch.largest(trial::run);
      assertTrue(largest > passive * 0.7 && largest < passive * 1.1, "largest=" + largest);
    }
  }

  /** Two runs show a margin of 2. The search for the largest stable stiffness takes many more. */
  @Test
  void everyDeviceIsStableAtItsDefaultStiffnessAndAtTwiceIt() {
    List<Trial> trials =
        new StabilityStudy(true, List.of(StabilityStudy.GUARDED), line -> {}).deviceTrials();
    for (DeviceModel device : DeviceModel.KNOWN) {
      assertTrue(
          trials.stream().anyMatch(each -> isHeavyAndHardlyDamped(each, device)), device.name());
    }
    for (Trial trial : trials) {
      double stiffness = MarginRow.defaultNewtonPerM(trial.device());
      assertTrue(trial.run(stiffness).stable(), trial + " at its default");
      assertTrue(trial.run(2 * stiffness).stable(), trial + " at twice its default");
    }
    MarginRow<Trial> first = MarginRow.of(trials.get(0));
    assertTrue(first.margin() >= 2 && first.atDefault().stable(), first.toString());
  }

  /** Whether a trial has twice the assumed mass, a quarter of the damping and a light grip. */
  private static boolean isHeavyAndHardlyDamped(Trial trial, DeviceModel device) {
    DeviceModel swept = trial.device();
    return swept.name().equals(device.name())
        && swept.handleKg() == 2 * device.handleKg()
        && swept.dampingNewtonSecondPerM() == 0.25 * device.dampingNewtonSecondPerM()
        && trial.grip().equals(Grip.LIGHT)
        && trial.sampling().delaySamples() == 2;
  }

  @Test
  void theBoundIsColgatesWithoutDelay() {
    assertEquals(2 * 3 * 1000, new Sampling(1000, 0).passiveNewtonPerM(3), 1e-9);
    assertEquals(3 * 1000 / 2.5, new Sampling(1000, 2).passiveNewtonPerM(3), 1e-9);
  }

  @Test
  void aForceActsAfterTheDelayForOneFrame() {
    for (int delay = 0; delay <= 2; delay++) {
      assertEquals(delay + 1, framesUntilPushed(delay), "delay=" + delay);
    }
  }

  /** Pushes sideways in the first frame and returns the frame in which the handle moves. */
  private static int framesUntilPushed(int delay) {
    Reach reach = new Reach(new Vec3(0, 0, 1), new Vec3(0, 0, -1), 1, 1);
    HandleMotion motion = new HandleMotion(BARE, Grip.NONE, reach);
    Plant plant = new Plant(BARE, new Sampling(1000, delay), reach, 1, motion, new Quaternion());
    DeviceState sample = new DeviceState();
    for (int frame = 0; frame < 10; frame++) {
      assertEquals(ReadStatus.FRESH, plant.read(sample));
      if (sample.positionMm.x > 0) {
        return frame;
      }
      plant.write(frame == 0 ? new Vec3(100, 0, 0) : new Vec3(), new Vec3());
    }
    return -1;
  }

  @Test
  void aTorqueTurnsTheHandleAboutItsAxisFromTheIntendedOrientation() {
    Reach reach = new Reach(new Vec3(0, 0, 1), new Vec3(0, 0, -1), 1, 1);
    Quaternion upright = new Quaternion().setRotationVector(new Vec3(0, 1, 0));
    HandleMotion motion = HandleMotion.turning(BARE, Grip.NONE, reach);
    Plant plant = new Plant(BARE, new Sampling(1000, 0), reach, 1, motion, upright);
    DeviceState sample = new DeviceState();
    plant.read(sample);
    assertEquals(1, Math.abs(sample.orientation.dot(upright)), 1e-12);
    for (int frame = 0; frame < 10; frame++) {
      plant.write(new Vec3(), new Vec3(40, 0, 0));
      plant.read(sample);
    }
    Vec3 turned =
        sample.orientation.multiply(upright.conjugate(upright), upright).rotationVector(new Vec3());
    double inertia = 0.1 * 0.02 * 0.02;
    assertEquals(0.5 * 0.04 / inertia * 0.01 * 0.01, turned.x, 0.1 * turned.x);
    assertEquals(0, turned.y, 1e-9);
    assertTrue(sample.positionMm.sameBits(new Vec3(0, 0, 1)), "no force, no motion");
  }

  @Test
  void aFirmlyHeldRodRestsOnAWallAtTheDefaultStiffnessOfEveryDevice() {
    for (DeviceModel device : DeviceModel.KNOWN) {
      for (double lengthMm : new double[] {0, 60}) {
        ToolTrial trial =
            new ToolTrial(device, Grip.FIRM, new Sampling(1000, 1), HeldRod.of(lengthMm));
        ClosedLoop.Outcome outcome = trial.run(500 * device.maxStiffnessNewtonPerMm());
        assertTrue(outcome.stable(), device.name() + " rod " + lengthMm + " " + outcome);
        assertTrue(outcome.riseNewtonPerMs() > 0, device.name() + " touches nothing");
      }
    }
  }

  @Test
  void aNeedleRestsInTissueAtTheDefaultStiffnessOfEveryDevice() {
    for (DeviceModel device : DeviceModel.KNOWN) {
      ToolTrial trial = new ToolTrial(device, Grip.LIGHT, new Sampling(1000, 1), new HeldNeedle());
      ClosedLoop.Outcome outcome = trial.run(500 * device.maxStiffnessNewtonPerMm());
      assertTrue(outcome.stable(), device.name() + " " + outcome);
      assertTrue(outcome.riseNewtonPerMs() > 0, device.name() + " touches nothing");
    }
  }

  @Test
  void aFirmlyHeldFragmentRestsAtTheDefaultStiffnessOfEveryDeviceWithAFitAndWithout() {
    for (DeviceModel device : DeviceModel.KNOWN) {
      double stiffness = MarginRow.defaultNewtonPerM(device);
      Sampling sampling = new Sampling(1000, 1);
      ClosedLoop.Outcome alone =
          new FragmentTrial(device, Grip.FIRM, sampling, false).run(stiffness);
      ClosedLoop.Outcome guided =
          new FragmentTrial(device, Grip.FIRM, sampling, true).run(stiffness);
      assertTrue(alone.stable(), device.name() + " " + alone);
      assertTrue(guided.stable(), device.name() + " with fit " + guided);
      assertTrue(guided.riseNewtonPerMs() > 2 * alone.riseNewtonPerMs(), "the fit guides");
    }
  }

  @Test
  void effectsArePassiveButForThoseThatTheDocumentsCallActive() {
    DeviceModel touch = DeviceModel.KNOWN.get(0);
    Set<String> active = new TreeSet<>();
    for (FeelTrial.Feel feel : FeelTrial.feels()) {
      FeelTrial trial = new FeelTrial(touch, Grip.LIGHT, new Sampling(1000, 1), feel);
      if (!trial.isPassive(trial.givenMillijoule(200))) {
        active.add(feel.name().replaceFirst(" .*", ""));
      }
    }
    assertTrue(Set.of("magnet", "texture", "vibration").containsAll(active), "active: " + active);
    assertTrue(active.contains("vibration"), "it follows time");
  }

  @Test
  void aBurrSinksWithoutVibrationAtTheDefaultStiffnessOfEveryDevice() {
    for (DeviceModel device : DeviceModel.KNOWN) {
      CarveTrial.Result result =
          new CarveTrial(device, Grip.LIGHT, new Sampling(1000, 1), 40).run(1);
      assertTrue(result.outcome().stable(), result.toString());
      assertTrue(result.cutMm3() > 30, result.toString());
    }
  }

  @Test
  void theIntendedMotionIsSmoothAndItsRateIsItsDerivative() {
    Reach reach = new Reach(new Vec3(), new Vec3(0, 0, 1), 0.2, 0.5);
    for (double t = 0.001; t < 0.9; t += 0.0137) {
      double slope = (reach.fraction(t + 1e-6) - reach.fraction(t - 1e-6)) / 2e-6;
      assertEquals(slope, reach.fractionRate(t), 1e-5, "t=" + t);
    }
    assertEquals(1, reach.fraction(0.5));
    assertEquals(0, reach.fraction(5));
  }

  @Test
  void aWallWithoutStiffnessGivesNoEnergy() {
    Trial trial =
        new Trial(
            BARE,
            Grip.FIRM,
            new Sampling(1000, 1),
            TouchedShape.wall(),
            StabilityStudy.GUARDED,
            true);
    assertEquals(0, trial.run(0).energyBackMillijoule());
    assertEquals(0, trial.run(0).riseNewtonPerMs());
  }

  @Test
  void everyShapeStopsTheHand() {
    for (TouchedShape shape : TouchedShape.all()) {
      Trial trial =
          new Trial(
              DeviceModel.KNOWN.get(0),
              Grip.FIRM,
              new Sampling(1000, 1),
              shape,
              StabilityStudy.GUARDED,
              true);
      ClosedLoop.Outcome outcome = trial.run(200);
      assertTrue(outcome.stable(), shape.name() + " " + outcome);
      assertTrue(outcome.riseNewtonPerMs() > 0, shape.name() + " " + outcome);
    }
  }

  @Test
  void aClosedMotionGivesTheSameBitsInEveryRound() {
    for (Trial.SolverChoice solver : StabilityRun.solvers().subList(0, 2)) {
      LongRun.Result result = new LongRun(solver, 7).run(20, line -> {});
      assertEquals(20L * LongRun.ROUND_FRAMES, result.frames());
      assertEquals(0, result.differingRounds(), solver.name());
      assertTrue(result.contactFrames() > result.frames() / 10, result.toString());
    }
  }

  @Test
  void tablesAndPlotsAreWritten() throws IOException {
    Trial trial =
        new Trial(
            DeviceModel.KNOWN.get(0),
            Grip.FIRM,
            new Sampling(1000, 1),
            TouchedShape.wall(),
            StabilityStudy.GUARDED,
            true);
    MarginRow<Trial> row =
        new MarginRow<>(trial, 200, 500, new ClosedLoop.Outcome(true, 0.01, 0.2, 0.03));
    ToolTrial held = new ToolTrial(trial.device(), Grip.FIRM, trial.sampling(), HeldRod.of(0));
    MarginRow<ToolTrial> tool = new MarginRow<>(held, 200, 300, row.atDefault());
    StudyTable.STABILITY_TOOLS.write(
        folder, List.of(tool), one -> StabilityRun.energyCells(one, -0.5));
    assertTrue(
        Files.readAllLines(folder.resolve("stability-tools.csv"))
            .get(1)
            .endsWith(",1000.0,1,0.05,0.5,200.0,300.0,1.5,0.01,0.2,0.03,-0.5,passive"));
    TheoryRow theory = new TheoryRow(new Sampling(1000, 1), 2, 1200, 1333);
    StudyTable.STABILITY_DEVICES.write(folder, List.of(row), MarginRow::cells);
    StudyTable.STABILITY_THEORY.write(folder, List.of(theory), TheoryRow::cells);
    assertEquals(
        "Touch,firm,wall,guarded,1000.0,1,0.05,0.5,200.0,500.0,2.5,0.01,0.2,0.03",
        Files.readAllLines(folder.resolve("stability-devices.csv")).get(1));
    Map<String, Double> margins = StabilityStudy.leastMargins(List.of(row));
    assertEquals(Map.of("Touch", 2.5), margins);
    StabilityPlots.plotTheory(folder.resolve("theory.png"), List.of(theory), 2);
    StabilityPlots.plotMargins(folder.resolve("margins.png"), margins);
    StabilityPlots.plotExcursion(folder.resolve("play.png"), List.of(row), "Touch");
    assertTrue(Files.size(folder.resolve("play.png")) > 1000);
  }
}
