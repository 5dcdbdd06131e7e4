package org.palpate.benchmarks.elastic;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.geometry.Vec3;

/**
 * Presses and slides on a block of 64 x 64 x 40 mm: steps of the force at updates, the force beside
 * that of a finer lattice, its direction beside the normal of the deformed surface.
 */
final class PressStudy {
  static final String FORCE = "force";
  static final String FORCE_AT = "force at depth";
  private static final double MIDDLE = 48.3;
  private static final double TOP = 48;
  private static final double PERCENT = 100;

  /** A smaller change of the force beyond stiffness times motion counts as no step, N. */
  private static final double LEAST_STEP_NEWTON = 1e-3;

  /** Depths of the hand at which a lattice is compared with a finer one, mm. */
  static final double[] DEPTHS = {2, 4, 6, 8, 10};

  private final List<Double> forceOverTime = new ArrayList<>();
  private final List<Integer> updateFrames = new ArrayList<>();

  /** Returns a session whose hand waits above the middle of the block. */
  static ElasticSession above(Softness softness) {
    ElasticSession session = new ElasticSession(SoftScene.block(), softness);
    session.hand().set(MIDDLE, MIDDLE, TOP + 3);
    session.run();
    session.moveTo(MIDDLE, MIDDLE, TOP + 3, 70);
    return session;
  }

  /** Watches how much more a force changes from frame to frame than stiffness times motion. */
  private static final class StepWatch {
    private final ElasticSession session;
    private final double newtonPerMm;
    private final Vec3 lastHand = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private final Vec3 motionOfHand = new Vec3();
    private final Vec3 difference = new Vec3();
    private long frames;
    private double atUpdates;
    private double anywhere;
    private long steps;

    /** The sum over the frames of the force against the motion, N. */
    private double againstMotion;

    StepWatch(ElasticSession session, double newtonPerMm) {
      this.session = session;
      this.newtonPerMm = newtonPerMm;
      remember();
    }

    private void remember() {
      lastHand.set(session.hand());
      lastForce.set(session.forceNewton());
    }

    void look() {
      double motion = session.hand().sub(lastHand, motionOfHand).length();
      double change = session.forceNewton().sub(lastForce, difference).length();
      double beyond = change - newtonPerMm * motion;
      anywhere = Math.max(anywhere, beyond);
      steps += beyond > LEAST_STEP_NEWTON ? 1 : 0;
      againstMotion -= motion > 0 ? session.forceNewton().dot(motionOfHand) / motion : 0;
      frames++;
      atUpdates = session.wasUpdated() ? Math.max(atUpdates, beyond) : atUpdates;
      remember();
    }
  }

  /** Returns the largest steps beyond stiffness times motion. */
  List<RigidFigure> steps() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double young : new double[] {5e3, 20e3, 100e3, 500e3}) {
      String condition = String.format(Locale.ROOT, "%.0f kPa, pressing 10 of 40 mm", young / 1e3);
      addSteps(condition, pressSteps(Softness.USUAL.withYoung(young)), 0.005, figures);
    }
    for (double depth : new double[] {5, 10}) {
      String condition = String.format(Locale.ROOT, "20 kPa, sliding 60 mm/s, %.0f mm deep", depth);
      StepWatch watch = slideSteps(Softness.USUAL, depth);
      addSteps(condition, watch, 0.03, figures);
      double newton = watch.againstMotion / watch.frames;
      figures.add(RigidFigure.of("step", condition, "mean force against the motion", newton, "N"));
    }
    return figures;
  }

  private static void addSteps(
      String condition, StepWatch watch, double target, List<RigidFigure> dest) {
    dest.add(
        new RigidFigure(
            "step", condition, "largest step at updates", watch.atUpdates, "N", target));
    dest.add(RigidFigure.of("step", condition, "largest step in any frame", watch.anywhere, "N"));
    dest.add(RigidFigure.of("step", condition, "frames with a step", (double) watch.steps, ""));
  }

  private StepWatch pressSteps(Softness softness) {
    ElasticSession session = above(softness);
    StepWatch watch = new StepWatch(session, softness.newtonPerMm());
    Runnable look = softness.equals(Softness.USUAL) ? plotted(session, watch) : watch::look;
    session.moveTo(MIDDLE, MIDDLE, TOP - 10, 1_300, look); // 10 mm/s
    session.moveTo(MIDDLE, MIDDLE, TOP - 10, 300, look);
    return watch;
  }

  /** Returns what also remembers the force of each frame for a plot. */
  private Runnable plotted(ElasticSession session, StepWatch watch) {
    return () -> {
      watch.look();
      if (session.wasUpdated()) {
        updateFrames.add(forceOverTime.size());
      }
      forceOverTime.add(session.forceNewton().length());
    };
  }

  private static StepWatch slideSteps(Softness softness, double depth) {
    ElasticSession session = above(softness);
    session.moveTo(MIDDLE - 12, MIDDLE, TOP + 2, 100);
    session.moveTo(MIDDLE - 12, MIDDLE, TOP - depth, 500);
    session.moveTo(MIDDLE - 12, MIDDLE, TOP - depth, 200);
    StepWatch watch = new StepWatch(session, softness.newtonPerMm());
    session.moveTo(MIDDLE + 12, MIDDLE, TOP - depth, 400, watch::look);
    return watch;
  }

  /** Returns the force of each frame while the usual press goes down and holds, N. */
  List<Double> forceOverTime() {
    return forceOverTime;
  }

  /** Returns the frames of {@link #forceOverTime} before which an update came. */
  List<Integer> updateFrames() {
    return updateFrames;
  }

  /** Returns the forces at rest beside those of a lattice with cells of half the edge. */
  List<RigidFigure> finer() {
    List<RigidFigure> figures = new ArrayList<>();
    double[] coarse = forcesAtRest(Softness.USUAL);
    double[] fine = forcesAtRest(Softness.USUAL.withCells(4, Softness.USUAL.radiusMm()));
    for (int n = 0; n < DEPTHS.length; n++) {
      figures.add(forceFigure("cells of 8 mm", DEPTHS[n], coarse[n]));
      figures.add(forceFigure("cells of 4 mm", DEPTHS[n], fine[n]));
    }
    for (int n = 0; n < DEPTHS.length; n++) {
      String condition = String.format(Locale.ROOT, "press, hand %.0f mm deep", DEPTHS[n]);
      double percent = PERCENT * Math.abs(coarse[n] / fine[n] - 1);
      figures.add(new RigidFigure(FORCE, condition, "off cells of half the edge", percent, "%", 5));
    }
    return figures;
  }

  private static RigidFigure forceFigure(String condition, double depth, double newton) {
    String name = String.format(Locale.ROOT, FORCE_AT + " %.0f mm", depth);
    return RigidFigure.of(FORCE, condition, name, newton, "N");
  }

  private static double[] forcesAtRest(Softness softness) {
    ElasticSession session = above(softness);
    double[] newton = new double[DEPTHS.length];
    for (int n = 0; n < newton.length; n++) {
      session.moveTo(MIDDLE, MIDDLE, TOP - DEPTHS[n], 200);
      session.moveTo(MIDDLE, MIDDLE, TOP - DEPTHS[n], 800);
      newton[n] = session.forceNewton().length();
    }
    return newton;
  }

  /** Returns the angles between the force and the normal of the deformed surface. */
  List<RigidFigure> directions() {
    List<RigidFigure> figures = new ArrayList<>();
    for (double cell : new double[] {8, 4}) {
      Softness softness = Softness.USUAL.withCells(cell, 2 * cell);
      figures.add(directionFigure(softness));
      figures.add(directionFigure(softness.withSmooth()));
    }
    return figures;
  }

  private static RigidFigure directionFigure(Softness softness) {
    ElasticSession session = above(softness);
    session.moveTo(MIDDLE - 8, MIDDLE, TOP + 2, 100);
    session.moveTo(MIDDLE - 8, MIDDLE, TOP - 5, 500);
    session.moveTo(MIDDLE - 8, MIDDLE, TOP - 5, 200);
    NormalWatch watch = new NormalWatch(session);
    session.moveTo(MIDDLE + 8, MIDDLE, TOP - 5, 1_000, watch::look); // 16 mm/s
    String condition =
        String.format(
            Locale.ROOT,
            "%s, cells of %.0f mm, sliding 16 mm/s, 5 mm deep",
            softness.solver(),
            softness.cellMm());
    return new RigidFigure(
        "direction", condition, "off the deformed normal, rms", watch.rmsDegrees(), "degrees", 2);
  }
}
