package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

class StatisticsTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_128);
  private static final Vec3 UP = new Vec3(0, 0, 1);

  private static Pose turned(double radians) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(radians, 0, 0));
    return pose;
  }

  @Test
  void aQuantileHasItsPartOfTheValuesBelowIt() {
    SplittableRandom random = new SplittableRandom(SEED);
    for (int count = 1; count < 300; count++) {
      double[] values = random.doubles(count).toArray();
      for (double part : new double[] {0.5, 0.9, 0.99, 0.999}) {
        double quantile = Quantile.of(values, part);
        long below = 0;
        for (double value : values) {
          below += value < quantile ? 1 : 0;
        }
        assertEquals((long) (part * count), below, "count=" + count + " part=" + part);
      }
    }
  }

  @Test
  void theEndsOfTheQuantilesAreTheLeastAndTheLargestValue() {
    double[] values = {3, -1, 7, 2};
    assertEquals(-1, Quantile.of(values, 0));
    assertEquals(7, Quantile.of(values, 1));
    assertArrayEquals(new double[] {3, -1, 7, 2}, values, "the values keep their order");
    assertThrows(IllegalArgumentException.class, () -> Quantile.of(new double[0], 0.5));
  }

  @Test
  void theAngleOfAForceIsItsDeviationFromTheNormalAsRootMeanSquare() {
    ForceMeter meter = new ForceMeter(10);
    meter.countDirection(new Vec3(0, 0, 5), UP);
    assertEquals(0, meter.rmsDegrees(), 1e-12);
    meter.countDirection(new Vec3(0, 3, 3), UP);
    assertEquals(Math.sqrt(45 * 45 / 2.0), meter.rmsDegrees(), 1e-9);
    meter.countDirection(new Vec3(), UP);
    assertEquals(Math.sqrt((45 * 45 + 180 * 180) / 3.0), meter.rmsDegrees(), 1e-9);
  }

  @Test
  void theForcePointsFromTheDeviceToTheTool() {
    ForceMeter meter = new ForceMeter(10);
    meter.count(Pose.at(0, 0, 2), Pose.at(0, 0, 0), UP);
    assertEquals(0, meter.rmsDegrees(), 1e-12);
    ForceMeter other = new ForceMeter(10);
    other.count(Pose.at(0, 0, 0), Pose.at(0, 0, 2), UP);
    assertEquals(180, other.rmsDegrees(), 1e-9);
  }

  @Test
  void aToolThatStaysOnASurfaceChangesItsForceAsMuchAsTheDeviceMovesInwards() {
    ForceMeter meter = new ForceMeter(10);
    for (int frame = 0; frame <= 50; frame++) {
      meter.count(Pose.at(0.3 * frame, 0, 0), Pose.at(0.3 * frame, 0, -0.4 * frame), UP);
    }
    assertEquals(0.4 / 0.5, meter.forceChangeP99(), 1e-9);
    assertEquals(0, meter.torqueChangeP99(), 1e-9);
  }

  @Test
  void aTurnOfTheDeviceCountsAtTheRadiusOfTheTool() {
    ForceMeter meter = new ForceMeter(10);
    for (int frame = 0; frame <= 50; frame++) {
      meter.count(turned(0), turned(0.001 * frame), UP);
    }
    assertEquals(0, meter.forceChangeP99(), 1e-9);
    assertEquals(1, meter.torqueChangeP99(), 1e-6);
  }

  @Test
  void aRareJumpOfTheForceDoesNotReachThePercentile() {
    ForceMeter meter = new ForceMeter(10);
    ForceMeter often = new ForceMeter(10);
    for (int frame = 0; frame <= 1_000; frame++) {
      Pose device = Pose.at(0, 0, 0.1 * frame);
      meter.count(Pose.at(0, frame == 500 ? 7 : 0, 0.1 * frame + 1), device, UP);
      often.count(Pose.at(0, frame % 100 == 50 ? 7 : 0, 0.1 * frame + 1), device, UP);
    }
    assertEquals(0, meter.forceChangeP99(), 1e-9);
    assertEquals(70, often.forceChangeP99(), 1e-6);
  }

  @Test
  void timesOverProcessesAreMediansAndBytesTheFewest() {
    List<List<FrameTimer.Times>> forks =
        List.of(
            List.of(new FrameTimer.Times(3, 90, 500), new FrameTimer.Times(1, 2, 7)),
            List.of(new FrameTimer.Times(900, 30, 0), new FrameTimer.Times(2, 4, 9)),
            List.of(new FrameTimer.Times(4, 40, 80), new FrameTimer.Times(9, 9, 8)));
    assertEquals(
        List.of(new FrameTimer.Times(4, 40, 0), new FrameTimer.Times(2, 4, 7)),
        FrameTimer.medians(forks));
  }

  @Test
  void aConditionComparesEachTimeWithItsOwnTarget() {
    TimedCondition condition =
        new TimedCondition("sphere", TimedCondition.Kind.CUBE, 1_000, ToolClearance.BODY, 25, 200);
    List<RigidFigure> figures = condition.figures(new FrameTimer.Times(25, 200.5, 0));
    assertEquals(List.of("met", "missed", "met"), verdicts(figures));
    assertEquals(
        List.of("missed", "met", "missed"),
        verdicts(condition.figures(new FrameTimer.Times(25.01, 200, 1))));
    assertEquals("sphere, 1000 points, body", figures.get(0).condition());
  }

  private static List<String> verdicts(List<RigidFigure> figures) {
    return figures.stream().map(RigidFigure::verdict).toList();
  }

  @Test
  void theRowOfAFigureNamesTargetAndVerdictOnlyIfThereIsATarget() {
    assertEquals(
        List.of("peg", "loose", "depth", 3.0, "mm", 2.0, "missed"),
        new RigidFigure("peg", "loose", "depth", 3, "mm", 2).cells());
    assertEquals(
        List.of("peg", "loose", "depth", 3.0, "mm", "", ""),
        RigidFigure.of("peg", "loose", "depth", 3, "mm").cells());
  }

  @Test
  void aTargetOfNoneIsMissedByTheFirstOne() {
    assertEquals("met", new RigidFigure("s", "c", "n", 0, "", 0).verdict());
    assertEquals("missed", new RigidFigure("s", "c", "n", 1, "", 0).verdict());
    assertEquals("missed", new RigidFigure("s", "c", "n", Double.MIN_VALUE, "", 0).verdict());
  }

  @Test
  void theNumberOfMissedTargetsIsPrintedAndReturned() {
    StringWriter text = new StringWriter();
    List<RigidFigure> figures =
        List.of(
            new RigidFigure("s", "c", "met", 2, "mm", 2),
            new RigidFigure("s", "c", "missed", 2.5, "mm", 2),
            new RigidFigure("s", "c", "not measured", Double.NaN, "mm", 2),
            RigidFigure.of("s", "c", "without a target", 1e9, "mm"));
    assertEquals(2, RigidRun.printMissed(figures, new PrintWriter(text)));
    assertEquals("2 of 3 targets missed", text.toString().strip());
  }

  @Test
  void aPrintedFigureShowsItsTargetAndVerdict() {
    StringWriter text = new StringWriter();
    RigidRun.print(
        List.of(new RigidFigure("s", "c", "n", 2.5, "mm", 2), RigidFigure.of("s", "c", "m", 7, "")),
        new PrintWriter(text));
    List<String> lines = text.toString().lines().toList();
    assertTrue(lines.get(0).contains(" 2.500 mm"), lines.get(0));
    assertTrue(lines.get(0).endsWith("at most 2: missed"), lines.get(0));
    assertTrue(lines.get(1).stripTrailing().endsWith(" 7"), lines.get(1));
  }
}
