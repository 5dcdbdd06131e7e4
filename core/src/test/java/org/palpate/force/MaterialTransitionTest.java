package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.proxy.InteractionPoint;
import org.palpate.testing.Seeds;

class MaterialTransitionTest {
  private static final double STRETCH_MM = 3;
  private static final double TOLERANCE = 1e-12;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());

  private Material randomMaterial() {
    double friction = random.nextDouble();
    return new Material(
        0.1 + random.nextDouble(), friction, friction * random.nextDouble(), random.nextDouble());
  }

  private static Material present(MaterialTransition felt) {
    return new Material(
        felt.stiffnessNewtonPerMm(),
        felt.staticFriction(),
        felt.slidingFriction(),
        felt.dampingNewtonSecondPerMm());
  }

  /** Returns the most that the force can change: coupling, static and sliding cone, damping. */
  private static double worstChange(Material from, Material to) {
    double k = Math.max(from.stiffnessNewtonPerMm(), to.stiffnessNewtonPerMm());
    double stiffer = Math.abs(from.stiffnessNewtonPerMm() - to.stiffnessNewtonPerMm());
    double mu = Math.max(from.staticFriction(), to.staticFriction());
    double rougher =
        Math.abs(from.staticFriction() - to.staticFriction())
            + Math.abs(from.slidingFriction() - to.slidingFriction());
    double most = Math.max(from.dampingNewtonSecondPerMm(), to.dampingNewtonSecondPerMm());
    double damped =
        Math.abs(from.dampingNewtonSecondPerMm() - to.dampingNewtonSecondPerMm()) / most;
    return STRETCH_MM * (stiffer * (2 + mu) + k * (rougher + damped));
  }

  private static void assertBetween(double share, double from, double to, double now) {
    assertEquals(from + share * (to - from), now, TOLERANCE, Seeds.seed() + "");
  }

  @Test
  void movesAllFourFiguresInStepByWhatTheMotionPermits() {
    for (int n = 0; n < 500; n++) {
      Material from = randomMaterial();
      Material to = randomMaterial();
      MaterialTransition felt = new MaterialTransition(2, from);
      double motion = random.nextDouble();
      felt.approach(to, STRETCH_MM, motion);
      double k = Math.max(from.stiffnessNewtonPerMm(), to.stiffnessNewtonPerMm());
      double permitted = k * Math.max(motion, 2 * ChangeBound.MIN_MOTION_EDGES);
      double share = Math.min(1, permitted / worstChange(from, to));
      assertBetween(
          share,
          from.stiffnessNewtonPerMm(),
          to.stiffnessNewtonPerMm(),
          felt.stiffnessNewtonPerMm());
      assertBetween(share, from.staticFriction(), to.staticFriction(), felt.staticFriction());
      assertBetween(share, from.slidingFriction(), to.slidingFriction(), felt.slidingFriction());
      assertBetween(
          share,
          from.dampingNewtonSecondPerMm(),
          to.dampingNewtonSecondPerMm(),
          felt.dampingNewtonSecondPerMm());
    }
  }

  @Test
  void arrivesAtTheBitsOfTheMaterialAndStaysThere() {
    Material from = randomMaterial();
    for (int figure = 0; figure < 4; figure++) {
      Material to =
          new Material(
              from.stiffnessNewtonPerMm() + (figure == 0 ? 0.1 : 0),
              from.staticFriction() + (figure == 1 ? 0.1 : 0),
              from.slidingFriction() * (figure == 2 ? 0.9 : 1),
              from.dampingNewtonSecondPerMm() + (figure == 3 ? 0.1 : 0));
      MaterialTransition felt = new MaterialTransition(1, from);
      int frames = 0;
      while (!present(felt).equals(to) && frames < 10_000) {
        felt.approach(to, STRETCH_MM, 0);
        frames++;
      }
      assertTrue(frames > 1 && frames < 1000, "figure " + figure + ": " + frames);
      felt.approach(to, STRETCH_MM, 0);
      assertEquals(to, present(felt));
    }
  }

  @Test
  void takesAMaterialAtOnceIfContactBeginsAndElseByATransition() {
    Material general = new Material(0.5, 0, 0, 0);
    Material hard = new Material(1, 0, 0, 0);
    ForceSettings settings =
        new ForceSettings(general, FrictionForm.EQUATION_4, true, List.of(general, hard));
    MaterialTransition felt = new MaterialTransition(1, general);
    felt.follow(settings, 1, true, STRETCH_MM, 0);
    assertEquals(1, felt.stiffnessNewtonPerMm());
    felt.follow(settings, 0, true, STRETCH_MM, 0);
    double between = felt.stiffnessNewtonPerMm();
    assertTrue(between < 1 && between > 0.9, "" + between);
    felt.follow(settings, InteractionPoint.NO_OBJECT, true, STRETCH_MM, 0);
    assertEquals(between, felt.stiffnessNewtonPerMm());
    felt.follow(settings, InteractionPoint.NO_OBJECT, false, STRETCH_MM, 0);
    felt.follow(settings, 0, true, STRETCH_MM, 0);
    assertEquals(0.5, felt.stiffnessNewtonPerMm());
    felt.reset();
    felt.follow(settings, 1, true, STRETCH_MM, 0);
    assertEquals(1, felt.stiffnessNewtonPerMm());
    felt.follow(ForceSettings.of(0.25, 0), 1, true, STRETCH_MM, 0);
    assertEquals(0.25, felt.stiffnessNewtonPerMm(), "objects that feel alike");
  }
}
