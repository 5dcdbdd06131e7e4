package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.function.IntFunction;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;

/** Directions and steadiness of the force of a tool that slides over surfaces of known normals. */
class RigidAccuracyTest {
  private static final double MAX_STEP_MM = 8;
  private static final double DEPTH_MM = 3;
  private static final int FRAMES = 600;

  private final ToolMotion motion = new ToolMotion();

  @Test
  void aToolOfOnePointFeelsLikeThePointSolver() {
    BodyScene scene = ToolScenes.phantom("sphere:96");
    RigidSolver solver = solver(scene, ToolSampler.point());
    CollisionScene solids = new CollisionScene(List.of(scene.body(0).bits()));
    SmoothSolver pointSolver = new SmoothSolver(new GridMetric(1, 1, 1), MAX_STEP_MM);
    InteractionPoint point = new InteractionPoint();
    Pose device = new Pose();
    double widest = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      onSphere(frame, 31.8, device.translation);
      if (frame == 0) {
        assertTrue(solver.place(device, motion));
        point.position.set(device.translation);
      }
      solver.follow(device, motion);
      pointSolver.follow(solids, device.translation, point);
      if (frame > 50) {
        Vec3 off = motion.pose().translation.sub(point.position, new Vec3());
        widest = Math.max(widest, off.length());
      }
    }
    assertTrue(widest < 0.8, "widest distance of the two points: " + widest);
  }

  /** A path at a constant depth below a sphere about the middle of a phantom of edge 96. */
  private static void onSphere(int frame, double radius, Vec3 dest) {
    double azimuth = 0.004 * frame;
    double height = 0.7 * Math.sin(0.003 * frame);
    double flat = Math.sqrt(1 - height * height);
    double r = frame < 30 ? radius + 6 - frame * 0.3 : radius - DEPTH_MM;
    dest.set(48 + r * flat * Math.cos(azimuth), 48 + r * flat * Math.sin(azimuth), 48 + r * height);
  }

  @Test
  void theForceOnASphereIsRadialAndSteady() {
    BodyScene scene = ToolScenes.phantom("sphere:96");
    double toolRadius = 5;
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(toolRadius), 0.5);
    Slide slide = new Slide(scene, tool);
    slide.run(
        frame -> {
          Pose pose = new Pose();
          onSphere(frame, 31.8 + toolRadius, pose.translation);
          return pose;
        },
        p -> p.sub(new Vec3(48, 48, 48), new Vec3()));
    assertTrue(slide.rmsDegrees() < 1.5, "rms " + slide.rmsDegrees());
    assertTrue(slide.changeQuantile(0.99) < 1, "p99 of change " + slide.changeQuantile(0.99));
    assertTrue(slide.torqueQuantile(0.99) < 1, "p99 of torque " + slide.torqueQuantile(0.99));
  }

  @Test
  void theForceOnAPlaneIsNormalAndSteadyForAFaceThatLiesFlat() {
    BodyScene scene = ToolScenes.phantom("plane:96");
    Vec3 n = new Vec3(0.231, 0.377, 0.894);
    n.mul(1 / n.length(), n);
    double tilt = Math.acos(n.z);
    double across = Math.hypot(n.x, n.y);
    RigidTool tool = ToolSampler.ofShape(new BoxShape(12, 12, 4), 0.7);
    Slide slide = new Slide(scene, tool);
    slide.run(
        frame -> {
          Pose pose = new Pose();
          pose.rotation.setRotationVector(new Vec3(-n.y / across * tilt, n.x / across * tilt, 0));
          double height = Math.max(2 - DEPTH_MM, 12 - 0.3 * frame);
          double along = 12 * Math.sin(0.006 * frame);
          n.mul(height, pose.translation);
          pose.translation.add(new Vec3(48, 48, 48), pose.translation);
          pose.translation.add(new Vec3(along * n.z, 0, -along * n.x), pose.translation);
          return pose;
        },
        p -> n);
    assertTrue(slide.rmsDegrees() < 0.5, "rms " + slide.rmsDegrees());
    assertTrue(slide.changeQuantile(0.99) < 0.3, "p99 of change " + slide.changeQuantile(0.99));
  }

  private static RigidSolver solver(BodyScene scene, RigidTool tool) {
    return new RigidSolver(scene, tool, RigidSettings.of(MAX_STEP_MM, Clearance.POINTS));
  }

  /** A session whose forces are compared with true normals. */
  private final class Slide {
    private final RigidSolver solver;
    private final RigidCoupling coupling;
    private final double[] changes = new double[FRAMES];
    private final Vec3 force = new Vec3();
    private final Vec3 lastForce = new Vec3();
    private final Vec3 torque = new Vec3();
    private final Vec3 lastTorque = new Vec3();
    private final double[] torqueChanges = new double[FRAMES];
    private final double rmsRadiusMm;
    private int counted;
    private double squaredDegrees;

    Slide(BodyScene scene, RigidTool tool) {
      solver = solver(scene, tool);
      coupling = RigidCoupling.of(tool, 1);
      rmsRadiusMm = tool.rmsRadiusMm();
    }

    void run(IntFunction<Pose> device, UnaryOperator<Vec3> normalAt) {
      Vec3 last = new Vec3();
      for (int frame = 0; frame < FRAMES; frame++) {
        Pose pose = device.apply(frame);
        if (frame == 0) {
          assertTrue(solver.place(pose, motion));
        }
        solver.follow(pose, motion);
        coupling.compute(motion.pose(), pose, force, torque);
        if (frame > 80) {
          count(normalAt.apply(pose.translation), pose.translation.sub(last, last).length());
        }
        last.set(pose.translation);
        lastForce.set(force);
        lastTorque.set(torque);
      }
      Arrays.sort(changes, 0, counted);
      Arrays.sort(torqueChanges, 0, counted);
      assertEquals(FRAMES - 81, counted);
    }

    private void count(Vec3 normal, double motionMm) {
      double cosine = force.dot(normal) / (force.length() * normal.length());
      double degrees = Math.toDegrees(Math.acos(Math.min(1, cosine)));
      squaredDegrees += degrees * degrees;
      changes[counted] = force.sub(lastForce, lastForce).length() / motionMm;
      double torqueChange = torque.sub(lastTorque, lastTorque).length() / rmsRadiusMm;
      torqueChanges[counted++] = torqueChange / motionMm;
    }

    double rmsDegrees() {
      return Math.sqrt(squaredDegrees / counted);
    }

    /** Returns a quantile of the change of torque, as a force at the rms radius. */
    double torqueQuantile(double q) {
      return torqueChanges[(int) (q * counted)];
    }

    double changeQuantile(double q) {
      return changes[(int) (q * counted)];
    }
  }
}
