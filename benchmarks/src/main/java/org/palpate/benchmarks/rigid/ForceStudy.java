package org.palpate.benchmarks.rigid;

import java.util.ArrayList;
import java.util.List;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * Slides a ball of 1,000 points over surfaces of known normals, and measures direction and
 * steadiness of its force.
 */
final class ForceStudy {
  private static final String STUDY = "force";
  private static final int EDGE = 192;
  private static final int POINTS = 1_000;
  private static final Vec3 ISOTROPIC = new Vec3(1, 1, 1);
  private static final Vec3 ANISOTROPIC = new Vec3(1, 1, 3);
  private static final double PLANE_CHANGE = 0.3;
  private static final double CURVED_CHANGE = 1;

  /** A surface and the largest rms angles that meet the targets, degrees. */
  private record Surface(String kind, double mostDegrees, double mostDegreesAnisotropic) {}

  private static final List<Surface> SURFACES =
      List.of(
          new Surface("plane", 0.5, 1),
          new Surface("sphere", 1.5, 2.5),
          new Surface("torus", 2.5, 4));

  private final int frames;
  private final long seed;

  ForceStudy(int frames, long seed) {
    this.frames = frames;
    this.seed = seed;
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (ToolClearance clearance : ToolClearance.values()) {
      for (Surface surface : SURFACES) {
        boolean isPlane = surface.kind.equals("plane");
        double mostChange = isPlane ? PLANE_CHANGE : CURVED_CHANGE;
        String condition = surface.kind + ", " + clearance.option;
        ForceMeter meter = measure(surface.kind, ISOTROPIC, clearance);
        figures.add(angle(condition, meter, surface.mostDegrees));
        figures.add(change(condition, "change of force, p99", meter.forceChangeP99(), mostChange));
        figures.add(
            change(condition, "change of torque, p99", meter.torqueChangeP99(), mostChange));
        meter = measure(surface.kind, ANISOTROPIC, clearance);
        figures.add(angle(condition + ", 1:1:3", meter, surface.mostDegreesAnisotropic));
      }
    }
    return figures;
  }

  private static RigidFigure angle(String condition, ForceMeter meter, double most) {
    return new RigidFigure(
        STUDY, condition, "angle of force, rms", meter.rmsDegrees(), "degrees", most);
  }

  private static RigidFigure change(String condition, String name, double value, double most) {
    return new RigidFigure(STUDY, condition, name, value, "mm/mm", most);
  }

  private ForceMeter measure(String kind, Vec3 spacingMm, ToolClearance clearance) {
    SurfaceScene scene = SurfaceScene.analytic(kind, EDGE, spacingMm);
    double radiusMm = MeasuredTools.ballRadiusMm(POINTS);
    RigidTool ball = MeasuredTools.ball(radiusMm);
    ToolRun run = new ToolRun(scene.bodies(), ball, clearance);
    BallSlide slide = new BallSlide(scene, radiusMm, frames, seed);
    ForceMeter meter = new ForceMeter(ball.rmsRadiusMm());
    Pose device = new Pose();
    Vec3 normal = new Vec3();
    run.start(slide.device(0, device));
    for (int frame = 0; frame < slide.frames(); frame++) {
      run.follow(slide.device(frame, device));
      if (frame >= slide.begin()) {
        meter.count(run.motion.pose(), device, slide.normal(frame, normal));
      }
    }
    return meter;
  }
}
