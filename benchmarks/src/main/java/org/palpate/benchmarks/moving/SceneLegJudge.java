package org.palpate.benchmarks.moving;

import org.palpate.benchmarks.stress.ExactJudge;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.BodyMotions;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.ReferencePose;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/**
 * Judges every leg of every pair of a scene exactly: of the tool and each body, and of each two
 * bodies of which one can move. It replays what a frame reports as committed, and knows nothing of
 * what verification looked at. One thread.
 */
final class SceneLegJudge {
  private final BodyScene bodies;
  private final RigidTool tool;
  private final MovableShapes shapes;
  private final ReferencePose[] references;
  private final ExactJudge judge = new ExactJudge();
  private final Pose toolPose = new Pose();
  private final Pose[] poses;
  private final Pose points = new Pose();
  private final Pose pointsTo = new Pose();
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 p = new Vec3();
  private final Ray ray = new Ray();
  private long legs;
  private long touching;
  private long broken;

  SceneLegJudge(BodyScene bodies, RigidTool tool, MovableShapes shapes) {
    this.bodies = bodies;
    this.tool = tool;
    this.shapes = shapes;
    poses = new Pose[bodies.count()];
    references = new ReferencePose[poses.length];
    for (int n = 0; n < poses.length; n++) {
      poses[n] = new Pose();
      RigidTool shape = shapes.shapes().get(n);
      references[n] = shape == null ? null : new ReferencePose(shape.referenceMm(new Vec3()));
    }
  }

  long legs() {
    return legs;
  }

  /** Returns the number of legs that touch a voxel. */
  long touching() {
    return touching;
  }

  /** Returns the number of motions that did not start where the last one ended. */
  long broken() {
    return broken;
  }

  /** Begins with bodies and tool as they stand. */
  void begin(ToolMotion motion) {
    for (int n = 0; n < poses.length; n++) {
      poses[n].set(bodies.body(n).pose());
    }
    toolPose.set(motion.pose());
    judgeTool(toolPose, -1, null);
    for (int n = 0; n < poses.length; n++) {
      judgeBody(n, poses[n]);
    }
  }

  /** Judges the last frame. */
  void judge(ToolMotion motion) {
    if (motion.freed()) {
      toolPose.set(motion.pathPose(0));
    }
    expect(motion.pathPose(0), toolPose);
    BodyMotions moved = motion.bodies();
    for (int n = 0; n < moved.count(); n++) {
      int body = moved.body(n);
      int step = moved.toolStep(n);
      expect(moved.from(n), poses[body]);
      judgeBody(body, moved.to(n));
      judgeTool(step < 0 ? toolPose : motion.pathPose(step + 1), body, moved.to(n));
      poses[body].set(moved.to(n));
    }
    for (int step = motion.pushes(); step < motion.steps(); step++) {
      judgeTool(motion.pathPose(step + 1), -1, null);
    }
    expect(motion.pose(), toolPose);
    for (int n = 0; n < poses.length; n++) {
      expect(bodies.body(n).pose(), poses[n]);
    }
  }

  private void expect(Pose actual, Pose expected) {
    broken += actual.sameBits(expected) ? 0 : 1;
  }

  /** Judges a step of the tool, during which one body may move too. */
  private void judgeTool(Pose toolTo, int moving, Pose bodyTo) {
    for (int n = 0; n < poses.length; n++) {
      Body body = bodies.body(n);
      body.toolToGrid(poses[n], toolPose, from);
      body.toolToGrid(n == moving ? bodyTo : poses[n], toolTo, to);
      judgeLegs(tool, body);
    }
    toolPose.set(toolTo);
  }

  /** Judges the motion of a body against all others. */
  private void judgeBody(int moving, Pose bodyTo) {
    for (int n = 0; n < poses.length; n++) {
      if (n != moving && (references[n] != null || references[moving] != null)) {
        if (carriesPoints(moving, n)) {
          judgePair(moving, bodyTo, n, poses[n]);
        } else {
          judgePair(n, poses[n], moving, bodyTo);
        }
      }
    }
  }

  /** Whether the first of two bodies carries the points: the one with fewer, or the earlier one. */
  private boolean carriesPoints(int a, int b) {
    if (references[a] == null || references[b] == null) {
      return references[b] == null;
    }
    int ofA = shapes.shapes().get(a).count();
    int ofB = shapes.shapes().get(b).count();
    return ofA < ofB || (ofA == ofB && a < b);
  }

  private void judgePair(int carrier, Pose carrierTo, int solid, Pose solidTo) {
    Body body = bodies.body(solid);
    references[carrier].toReference(poses[carrier], points);
    references[carrier].toReference(carrierTo, pointsTo);
    body.toolToGrid(poses[solid], points, from);
    body.toolToGrid(solidTo, pointsTo, to);
    judgeLegs(shapes.shapes().get(carrier), body);
  }

  private void judgeLegs(RigidTool ofPoints, Body body) {
    for (int n = 0; n < ofPoints.count(); n++) {
      ofPoints.point(n, p);
      ray.from(from.x(p.x, p.y, p.z), from.y(p.x, p.y, p.z), from.z(p.x, p.y, p.z));
      ray.to(to.x(p.x, p.y, p.z), to.y(p.x, p.y, p.z), to.z(p.x, p.y, p.z));
      legs++;
      touching += judge.touches(body.bits(), ray) ? 1 : 0;
    }
  }
}
