package org.palpate.benchmarks.elastic;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.geometry.Vec3;

class ElasticStudiesTest {
  private static final long SEED = 5;

  private static double value(List<RigidFigure> figures, String condition, String name) {
    return figures.stream()
        .filter(f -> f.condition().contains(condition) && f.name().equals(name))
        .findFirst()
        .orElseThrow()
        .value();
  }

  @Test
  void theAttackFindsNothing() {
    ElasticAttack attack = new ElasticAttack(SEED);
    attack.attack(UpdatePace.USUAL, 5_000, 200_000);
    attack.attack(UpdatePace.RARE, 50_000, 200_000);
    List<RigidFigure> figures = attack.figures();
    figures.forEach(figure -> assertTrue(!figure.verdict().equals("missed"), figure.toString()));
    assertTrue(value(figures, "", "updates") > 100);
    assertTrue(value(figures, "", "legs judged") >= 50_000);
    assertTrue(value(figures, "", "verdicts also given in decimal fractions alone") >= 1_000);
    assertTrue(value(figures, "", "planted legs") > 200);
  }

  @Test
  void theAttackOfContactsInAWindowFindsNothing() {
    ElasticAttack attack = new ElasticAttack(SEED, true);
    attack.attack(UpdatePace.USUAL, 1_000, 200_000);
    List<RigidFigure> figures = attack.figures();
    figures.forEach(figure -> assertTrue(!figure.verdict().equals("missed"), figure.toString()));
    double judged = value(figures, "contacts in a window", "judged fields with a window");
    assertTrue(judged > 10, "judged " + judged);
  }

  @Test
  void beamsBendAsTheFormulaSays() {
    List<RigidFigure> figures = new FormulaStudy(true).figures();
    String figure = "cantilever 96x16x16, off the formula";
    assertEquals(2.7, value(figures, "elements alone, cells of 16 mm", figure), 0.1);
    assertTrue(value(figures, "in the air of a lattice, cells of 8 mm", figure) < 3);
    String plate = "plate 96x16x2, off the formula";
    assertTrue(value(figures, "in the air of a lattice, cells of 8 mm", plate) < 20);
    String disc = "disc on a half space, off the formula";
    assertEquals(17.2, value(figures, "radius of one cell", disc), 0.2, "half of it with each");
    assertEquals(9.0, value(figures, "radius of 2 cells", disc), 0.2, "halving of the cells");
    assertTrue(value(figures, "radius of one cell, in a window", disc) < 10);
    String window = "disc on a cube, off a whole lattice of short cells";
    assertTrue(value(figures, "radius of one cell, in a window", window) < 2);
  }

  @Test
  void aSlideUnderALoadTurnsTheNormalOfTheSurface() {
    ElasticSession session = PressStudy.above(Softness.USUAL);
    Vec3 hand = session.hand();
    session.moveTo(hand.x, hand.y, 44, 300);
    session.moveTo(hand.x, hand.y, 44, 300);
    NormalWatch watch = new NormalWatch(session);
    watch.look();
    assertTrue(watch.rmsDegrees() < 0.5, "at rest over the middle, " + watch.rmsDegrees());
    session.forceNewton().set(session.forceNewton().z, 0, session.forceNewton().z);
    NormalWatch tilted = new NormalWatch(session);
    tilted.look();
    assertEquals(45, tilted.rmsDegrees(), 1, "a planted tilt");
  }
}
