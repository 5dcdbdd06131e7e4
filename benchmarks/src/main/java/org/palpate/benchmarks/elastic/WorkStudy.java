package org.palpate.benchmarks.elastic;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.geometry.Vec3;

/**
 * Presses and releases, with and without a slide between, and compares the work that the hand gets
 * back with the work that it does. Between two frames the work is the mean of both forces times the
 * motion.
 */
final class WorkStudy {
  private static final double MIDDLE = 48.3;
  private static final double TOP = 48;
  private static final double ABOVE = 3;
  private static final double MOST_RATIO = 1.01;
  private static final double FRAMES_PER_SECOND = 1000;
  private static final int HOLD_FRAMES = 300;

  /** Sums the work of a hand. */
  private static final class Work {
    private final ElasticSession session;
    private final Vec3 lastHand = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private final Vec3 motion = new Vec3();
    private double taken;
    private double returned;
    private double largestNewton;

    Work(ElasticSession session) {
      this.session = session;
      lastHand.set(session.hand());
    }

    void look() {
      session.hand().sub(lastHand, motion);
      double mj = 0.5 * (lastForce.dot(motion) + session.forceNewton().dot(motion));
      taken += Math.max(0, -mj);
      returned += Math.max(0, mj);
      lastHand.set(session.hand());
      lastForce.set(session.forceNewton());
      largestNewton = Math.max(largestNewton, lastForce.length());
    }
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double depth : new double[] {4, 10}) {
      for (double speed : new double[] {10, 60, 200, 500}) {
        for (double slide : new double[] {0, 16}) {
          figures.addAll(cycle(depth, speed, slide));
        }
      }
    }
    return figures;
  }

  private static List<RigidFigure> cycle(double depth, double speed, double slide) {
    ElasticSession session = PressStudy.above(Softness.USUAL);
    Work work = new Work(session);
    int down = (int) Math.round((depth + ABOVE) / speed * FRAMES_PER_SECOND);
    double bottom = TOP - depth;
    session.moveTo(MIDDLE, MIDDLE, bottom, down, work::look);
    session.moveTo(MIDDLE, MIDDLE, bottom, HOLD_FRAMES, work::look);
    if (slide > 0) {
      int across = (int) Math.round(slide / speed * FRAMES_PER_SECOND);
      session.moveTo(MIDDLE + slide, MIDDLE, bottom, across, work::look);
      session.moveTo(MIDDLE + slide, MIDDLE, bottom, HOLD_FRAMES, work::look);
    }
    session.moveTo(MIDDLE + slide, MIDDLE, TOP + ABOVE, down, work::look);
    session.moveTo(MIDDLE + slide, MIDDLE, TOP + ABOVE, HOLD_FRAMES, work::look);
    String condition =
        String.format(
            Locale.ROOT, "%.0f mm deep, %.0f mm/s, slide of %.0f mm", depth, speed, slide);
    double ratio = work.returned / work.taken;
    return List.of(
        new RigidFigure("work", condition, "returned over taken", ratio, "", MOST_RATIO),
        RigidFigure.of("work", condition, "largest force", work.largestNewton, "N"),
        RigidFigure.of(
            "work",
            condition,
            "frames with a lowered force",
            (double) session.body().contact().loweredFrames(),
            ""));
  }
}
