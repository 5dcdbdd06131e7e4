package org.palpate.benchmarks.rigid;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.loop.Median;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Compares the rigid tool of this project with published methods. With each of them the same tool,
 * a ball, is pressed into a larger ball and slides over it. The study measures the time of a frame,
 * the penetration and the direction of the force.
 */
final class PeerStudy {
  static final String STUDY = "peers";

  private static final ThreadMXBean THREADS = ManagementFactory.getThreadMXBean();
  private static final int EDGE = 192;

  /** The number of points that the paper reached with response. */
  private static final int PAPER_POINTS = 145;

  private static final int POINTS = 1_000;

  private final int frames;
  private final long seed;

  PeerStudy(int frames, long seed) {
    this.frames = frames;
    this.seed = seed;
  }

  List<RigidFigure> figures() {
    SurfaceScene scene = SurfaceScene.of("sphere", EDGE);
    BitCube bits = scene.bodies().body(0).bits();
    List<RigidFigure> figures = new ArrayList<>();
    for (int points : new int[] {PAPER_POINTS, POINTS}) {
      double radiusMm = MeasuredTools.ballRadiusMm(points);
      RigidTool ball = MeasuredTools.ball(radiusMm).thinned(points);
      Map<String, PeerTool> peers = new LinkedHashMap<>();
      peers.put("Palpate", new RigidPeer(new ToolRun(scene.bodies(), ball, ToolClearance.POINTS)));
      peers.put("penalty, 1999", new PenaltyPeer(bits, ball));
      peers.put("paper, 2013", new PaperPeer(bits, ball));
      BallSlide slide = new BallSlide(scene, radiusMm, frames, seed);
      peers.forEach(
          (name, peer) ->
              figures.addAll(measure(scene, name + ", " + points + " points", peer, slide)));
    }
    return figures;
  }

  private static List<RigidFigure> measure(
      SurfaceScene scene, String condition, PeerTool peer, BallSlide slide) {
    run(scene, peer, slide, new double[slide.frames()]); // warms up
    double[] nanos = new double[slide.frames()];
    Errors errors = run(scene, peer, slide, nanos);
    return List.of(
        RigidFigure.of(STUDY, condition, "frame, p50", Median.of(nanos) / 1e3, "us"),
        RigidFigure.of(STUDY, condition, "frame, p99.9", Quantile.of(nanos, 0.999) / 1e3, "us"),
        RigidFigure.of(STUDY, condition, "penetration, most", errors.deepestMm, "mm"),
        RigidFigure.of(
            STUDY, condition, "angle of force, rms", errors.meter.rmsDegrees(), "degrees"));
  }

  /** The errors of a method. */
  private static final class Errors {
    final ForceMeter meter = new ForceMeter(0);
    double deepestMm;
  }

  private static Errors run(SurfaceScene scene, PeerTool peer, BallSlide slide, double[] nanos) {
    Errors errors = new Errors();
    Pose device = new Pose();
    Vec3 force = new Vec3();
    Vec3 normal = new Vec3();
    peer.place(slide.device(0, device));
    for (int frame = 0; frame < slide.frames(); frame++) {
      slide.device(frame, device);
      long begin = THREADS.getCurrentThreadCpuTime();
      peer.follow(device);
      nanos[frame] = THREADS.getCurrentThreadCpuTime() - begin;
      if (frame >= slide.begin()) {
        errors.meter.countDirection(peer.force(device, force), slide.normal(frame, normal));
        errors.deepestMm = Math.max(errors.deepestMm, deepestMm(scene, peer));
      }
    }
    return errors;
  }

  /** Returns the depth of the deepest point that lies in a solid voxel, below the true surface. */
  private static double deepestMm(SurfaceScene scene, PeerTool peer) {
    BitCube bits = scene.bodies().body(0).bits();
    double deepest = 0;
    Vec3 at = new Vec3();
    for (int n = 0; n < peer.count(); n++) {
      peer.point(n, at);
      boolean inSolid =
          bits.get((int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z));
      deepest = inSolid ? Math.max(deepest, -scene.truth().signedDistance(at)) : deepest;
    }
    return deepest;
  }

  /** The rigid tool of this project, as one of the compared methods. */
  private static final class RigidPeer implements PeerTool {
    private final ToolRun run;

    RigidPeer(ToolRun run) {
      this.run = run;
    }

    @Override
    public void place(Pose pose) {
      run.start(pose);
    }

    @Override
    public void follow(Pose device) {
      run.follow(device);
    }

    @Override
    public Vec3 force(Pose device, Vec3 dest) {
      return run.motion.pose().translation.sub(device.translation, dest);
    }

    @Override
    public int count() {
      return run.tool.count();
    }

    @Override
    public Vec3 point(int index, Vec3 dest) {
      return run.motion.pose().transform(run.tool.point(index, dest), dest);
    }
  }
}
