package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import org.palpate.collision.CollisionDevice;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.tool.RigidTool;

/**
 * A scene and a tool whose frames are timed.
 *
 * @param surface the phantom
 * @param kind the tool
 * @param points about how many sample points the tool has, or its lower face if that lies flat
 * @param clearance the clearance that the tool keeps
 * @param mostP50 the target for p50, us; NaN without one
 * @param mostP999 the target for p99.9, us; NaN without one
 */
record TimedCondition(
    String surface,
    Kind kind,
    int points,
    ToolClearance clearance,
    double mostP50,
    double mostP999) {
  static final String STUDY = "time";
  static final String P50 = "frame, p50";
  static final String P999 = "frame, p99.9";

  private static final int EDGE = 192;
  private static final int[] POINTS = {1_000, 5_000, 20_000, 100_000};
  private static final double[] MOST_P50 = {25, 50, 90, 180};
  private static final double[] MOST_P999 = {200, 400, 600, 950};
  private static final double NONE = Double.NaN;

  /** The tools. */
  enum Kind {
    /** A cube that is tilted against the surface. */
    CUBE,

    /** A cube whose face lies on the surface. */
    FLAT_CUBE,

    /** A thin plate whose face lies on the surface. */
    PLATE
  }

  /** Returns all conditions in the order of the tables. */
  static List<TimedCondition> all() {
    List<TimedCondition> all = new ArrayList<>();
    for (ToolClearance clearance : ToolClearance.values()) {
      for (String surface : List.of("sphere", "torus", "skull")) {
        for (int n = 0; n < POINTS.length; n++) {
          all.add(
              new TimedCondition(
                  surface, Kind.CUBE, POINTS[n], clearance, MOST_P50[n], MOST_P999[n]));
        }
      }
      for (Kind kind : List.of(Kind.FLAT_CUBE, Kind.PLATE)) {
        all.add(new TimedCondition("plane", kind, 5_000, clearance, NONE, 450));
        all.add(new TimedCondition("plane", kind, 20_000, clearance, NONE, 950));
      }
    }
    return all;
  }

  /** Returns the condition as tables name it. */
  String label() {
    String tool = kind == Kind.PLATE ? "face of " + points : points + " points";
    String lies = kind == Kind.FLAT_CUBE ? " flat" : "";
    return surface + ", " + tool + lies + ", " + clearance.option;
  }

  /** Returns the figures of this condition. */
  List<RigidFigure> figures(FrameTimer.Times times) {
    String label = label();
    return List.of(
        new RigidFigure(STUDY, label, P50, times.p50Us(), "us", mostP50),
        new RigidFigure(STUDY, label, P999, times.p999Us(), "us", mostP999),
        new RigidFigure(STUDY, label, "allocated in a quarter, least", times.bytes(), "B", 0));
  }

  /** A tool that a device has pressed onto the surface. */
  record Pressed(ToolRun run, PressAndSlide device) {}

  /** Makes scene and tool, and presses the tool onto the surface. */
  Pressed pressed() {
    return pressed(CollisionDevice.CPU);
  }

  /** Does the same with a device that judges legs. */
  Pressed pressed(CollisionDevice judge) {
    SurfaceScene scene = SurfaceScene.of(surface, EDGE);
    RigidTool tool = kind == Kind.PLATE ? MeasuredTools.plate(points) : MeasuredTools.cube(points);
    PressAndSlide device = new PressAndSlide(scene, kind != Kind.CUBE);
    RigidSettings plain = clearance.settings(scene.bodies(), tool);
    ToolRun run =
        new ToolRun(
            scene.bodies(),
            tool,
            new RigidSettings(
                plain.maxStepMm(), plain.clearances(), plain.greys(), plain.skips(), judge));
    device.press(run);
    return new Pressed(run, device);
  }
}
