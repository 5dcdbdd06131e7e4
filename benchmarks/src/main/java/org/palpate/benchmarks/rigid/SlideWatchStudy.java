package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.rigid.tool.RigidTool;

/** Slides a cube of 5,000 points over open surfaces and looks for stuck and restless frames. */
final class SlideWatchStudy {
  private static final int EDGE = 128;
  private static final int POINTS = 5_000;

  /** The device pauses after each of these many frames. */
  private static final int FRAMES_BETWEEN_RESTS = 250;

  private final int frames;
  private final long seed;

  SlideWatchStudy(int frames, long seed) {
    this.frames = frames;
    this.seed = seed;
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (String surface : List.of("plane", "sphere", "torus", "skull")) {
      for (ToolClearance clearance : ToolClearance.values()) {
        ToolWatch watch = new ToolWatch(seed);
        slide(SurfaceScene.of(surface, EDGE), clearance, watch);
        figures.addAll(watch.figures(surface + ", " + clearance.option));
      }
    }
    return figures;
  }

  private void slide(SurfaceScene scene, ToolClearance clearance, ToolWatch watch) {
    RigidTool tool = MeasuredTools.cube(POINTS);
    ToolRun run = new ToolRun(scene.bodies(), tool, clearance);
    KeepOut keepOut = new KeepOut(scene.bodies(), tool, clearance.clearance(scene.bodies(), tool));
    PressAndSlide hand = new PressAndSlide(scene, false);
    hand.press(run);
    Pose device = new Pose();
    for (int frame = 0; frame < frames; frame++) {
      run.follow(hand.device(frame, device));
      watch.watch(run, keepOut, device);
      if (frame % FRAMES_BETWEEN_RESTS == FRAMES_BETWEEN_RESTS - 1) {
        watch.rest(run, device);
      }
    }
  }
}
