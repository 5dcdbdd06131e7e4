package org.palpate.benchmarks.elastic;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.geometry.Vec3;

/**
 * Lets a hand of some mass rest on soft material: a grip pulls it to a goal below the surface. The
 * figure is how far it still moves after two seconds.
 */
final class RestStudy {
  private static final double MIDDLE = 48.3;
  private static final double TOP = 48;
  private static final double DEEP_MM = 6;
  private static final double GRIP_NEWTON_PER_MM = 0.3;
  private static final double DAMPING_NEWTON_SECOND_PER_M = 2;
  private static final double SECONDS = 1e-3;
  private static final double MM_PER_M = 1e3;
  private static final int FRAMES = 2_500;
  private static final int WATCHED = 500;
  private static final int MOVING_DOWN = 300;

  /** A hand that rests moves by less than this, mm. */
  private static final double AT_REST_MM = 0.01;

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double young : new double[] {2e3, 5e3, 20e3, 100e3}) {
      for (double k : new double[] {0.25, 1, 4}) {
        for (double kg : new double[] {0.1, 0.02}) {
          figures.add(rest(young, k, kg));
        }
      }
    }
    return figures;
  }

  private static RigidFigure rest(double young, double newtonPerMm, double kg) {
    Softness softness = Softness.USUAL.withYoung(young).withStiffness(newtonPerMm);
    double compliance = compliance(softness);
    ElasticSession session = PressStudy.above(softness);
    Vec3 hand = session.hand();
    Vec3 speed = new Vec3();
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (int n = 0; n < FRAMES; n++) {
      double down = Math.min(1.0, (double) n / MOVING_DOWN);
      double goal = TOP + 3 - down * (3 + DEEP_MM);
      session.run();
      pull(session, goal, kg, speed);
      if (n >= FRAMES - WATCHED) {
        low = Math.min(low, hand.z);
        high = Math.max(high, hand.z);
      }
    }
    String condition =
        String.format(
            Locale.ROOT,
            "%.0f kPa, %.2f N/mm, hand of %.2f kg, stiffness times compliance %.1f",
            young / 1e3,
            newtonPerMm,
            kg,
            newtonPerMm * compliance);
    return new RigidFigure(
        "rest", condition, "motion in half a second", high - low, "mm", AT_REST_MM);
  }

  /** Moves the hand for a frame under the force, the grip and its damping. */
  private static void pull(ElasticSession session, double goal, double kg, Vec3 speed) {
    Vec3 hand = session.hand();
    double[] goals = {MIDDLE, MIDDLE, goal};
    for (int axis = 0; axis < 3; axis++) {
      double newton =
          session.forceNewton().get(axis)
              + GRIP_NEWTON_PER_MM * (goals[axis] - hand.get(axis))
              - DAMPING_NEWTON_SECOND_PER_M * speed.get(axis) / MM_PER_M;
      speed.set(axis, speed.get(axis) + MM_PER_M * SECONDS * newton / kg);
      hand.set(axis, hand.get(axis) + SECONDS * speed.get(axis));
    }
  }

  /** Returns how far the surface gives way under a small force, mm/N. */
  private static double compliance(Softness softness) {
    ElasticSession session = PressStudy.above(softness);
    session.moveTo(MIDDLE, MIDDLE, TOP - 1, 400);
    session.moveTo(MIDDLE, MIDDLE, TOP - 1, 400);
    return (TOP - session.present().z) / session.forceNewton().length();
  }
}
