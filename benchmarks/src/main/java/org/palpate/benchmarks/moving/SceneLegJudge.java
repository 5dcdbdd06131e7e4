package org.palpate.benchmarks.moving;

import java.util.Arrays;
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
 * what verification looked at. While a body is held, the tool is not in the scene. One thread.
 */
final class SceneLegJudge {
  private static final int NOTHING = -1;

  private final BodyScene bodies;
  private final int tool;
  private final RigidTool[] shapes;
  private final ReferencePose[] references;
  private final ExactJudge judge = new ExactJudge();

  /** Poses of bodies, rest to present, and of the tool, which comes last. */
  private final Pose[] poses;

  private final Pose[] next;
  private final Pose points = new Pose();
  private final Pose pointsTo = new Pose();
  private final Pose rest = new Pose();
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 p = new Vec3();
  private final Ray ray = new Ray();
  private int hand;

  /** For each body that moves along, its pose in the frame of the held one; null for the others. */
  private final Pose[] inHand;

  private final Pose takenAt = new Pose();
  private final Pose[] joined;
  private long legs;
  private long touching;
  private long broken;

  SceneLegJudge(BodyScene bodies, RigidTool tool, MovableShapes shapes) {
    this.bodies = bodies;
    this.tool = bodies.count();
    this.shapes = new RigidTool[this.tool + 1];
    poses = new Pose[this.tool + 1];
    next = new Pose[this.tool + 1];
    inHand = new Pose[this.tool];
    joined = new Pose[this.tool];
    references = new ReferencePose[this.tool + 1];
    for (int n = 0; n <= this.tool; n++) {
      poses[n] = new Pose();
      next[n] = new Pose();
      this.shapes[n] = n == this.tool ? tool : shapes.shapes().get(n);
      boolean moves = n < this.tool && this.shapes[n] != null;
      references[n] = moves ? new ReferencePose(this.shapes[n].referenceMm(new Vec3())) : null;
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

  /** Begins with bodies and tool as they stand; the hand holds the tool. */
  void begin(ToolMotion motion) {
    for (int n = 0; n < tool; n++) {
      poses[n].set(bodies.body(n).pose());
    }
    poses[tool].set(motion.pose());
    hand = tool;
    for (int n = 0; n <= tool; n++) {
      next[n].set(poses[n]);
    }
    for (int n = 0; n <= tool; n++) {
      judgeStep(n, NOTHING);
    }
  }

  /** Takes note that the hand holds a body from now on, which has not moved. */
  void take(int body, ToolMotion motion) {
    hand = body;
    takenAt.set(motion.pose());
    expect(handPose(motion.pose()), poses[body]);
  }

  /** Takes note that a body moves along with the one that was just taken. */
  void join(int body) {
    Pose own = references[body].toReference(poses[body], new Pose());
    inHand[body] = ReferencePose.relative(takenAt, own, new Pose());
    joined[body] = new Pose().set(poses[body]);
  }

  /** Takes note that the hand let go of a body, and that the tool was placed. */
  void letGo(ToolMotion motion) {
    hand = tool;
    Arrays.fill(inHand, null);
    poses[tool].set(motion.pose());
    next[tool].set(motion.pose());
    judgeStep(tool, NOTHING);
  }

  /**
   * Judges the last frame. Voxels must not change after {@link #begin}, so a tool that is set free
   * breaks the chain too.
   */
  void judge(ToolMotion motion) {
    expect(handPose(motion.pathPose(0)), poses[hand]);
    BodyMotions moved = motion.bodies();
    for (int n = 0; n < moved.count(); n++) {
      int body = moved.body(n);
      int step = moved.toolStep(n);
      expect(moved.from(n), poses[body]);
      next[body].set(moved.to(n));
      if (step >= 0) {
        next[hand].set(handPose(motion.pathPose(step + 1)));
      }
      judgeStep(body, step < 0 ? NOTHING : hand);
    }
    for (int step = motion.pushes(); step < motion.steps(); step++) {
      next[hand].set(handPose(motion.pathPose(step + 1)));
      setCarried(motion.pathPose(step + 1));
      judgeStep(hand, NOTHING);
    }
    expect(handPose(motion.pose()), poses[hand]);
    for (int n = 0; n < tool; n++) {
      expect(bodies.body(n).pose(), poses[n]);
    }
  }

  /** Returns the pose of what is held: of the tool, or from rest to present. */
  private Pose handPose(Pose inMotion) {
    return hand == tool ? inMotion : references[hand].toRest(inMotion, rest);
  }

  private void setCarried(Pose ofHand) {
    boolean isAtStart = ofHand.sameBits(takenAt);
    for (int n = 0; n < tool; n++) {
      if (inHand[n] != null) {
        ReferencePose.glued(ofHand, inHand[n], points);
        next[n].set(isAtStart ? joined[n] : references[n].toRest(points, rest));
      }
    }
  }

  private void expect(Pose actual, Pose expected) {
    broken += actual.sameBits(expected) ? 0 : 1;
  }

  /** Judges a step of one mover, or of several at the same time, against all others. */
  private void judgeStep(int one, int other) {
    for (int a = 0; a <= tool; a++) {
      for (int b = 0; b < a; b++) {
        boolean moves = isMoved(a, one, other) || isMoved(b, one, other);
        boolean isPresent = a < tool || hand == tool;
        if (moves && isPresent && (shapes[a] != null || shapes[b] != null)) {
          judgePair(a, b);
        }
      }
    }
    for (int n = 0; n <= tool; n++) {
      poses[n].set(next[n]);
    }
  }

  private boolean isMoved(int n, int one, int other) {
    return n == one || n == other || !next[n].sameBits(poses[n]);
  }

  /**
   * Judges the legs of a pair. The tool carries the sample points. Of two bodies, the one with
   * fewer points carries them; if both have equally many, the earlier one does.
   */
  private void judgePair(int later, int earlier) {
    boolean laterCarries =
        later == tool
            || shapes[earlier] == null
            || (shapes[later] != null && shapes[later].count() < shapes[earlier].count());
    int carrier = laterCarries ? later : earlier;
    int solid = laterCarries ? earlier : later;
    Body body = bodies.body(solid);
    body.toolToGrid(poses[solid], pointsPose(carrier, poses[carrier], points), from);
    body.toolToGrid(next[solid], pointsPose(carrier, next[carrier], pointsTo), to);
    judgeLegs(shapes[carrier], body);
  }

  private Pose pointsPose(int carrier, Pose pose, Pose dest) {
    return carrier == tool ? pose : references[carrier].toReference(pose, dest);
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
