package org.palpate.benchmarks.rigid;

import org.palpate.benchmarks.stress.ExactJudge;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/**
 * Judges every leg of every sample point exactly, from the committed poses alone. It does not know
 * what the solver looked at or left out. One thread.
 */
public final class RigidLegJudge {
  private final ExactJudge judge = new ExactJudge();
  private final ExactJudge reference = ExactJudge.unfiltered();
  private final long mostCompared;
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 position = new Vec3();
  private final Ray ray = new Ray();
  private final Pose end = new Pose();
  private long legs;
  private long touching;
  private long broken;
  private long compared;
  private long disagreements;

  /**
   * Creates a judge.
   *
   * @param mostCompared the number of legs that are also decided in decimals of unlimited precision
   */
  public RigidLegJudge(long mostCompared) {
    this.mostCompared = mostCompared;
  }

  /** Returns the number of legs judged. */
  public long legs() {
    return legs;
  }

  /** Returns the number of legs that touch a voxel. */
  public long touching() {
    return touching;
  }

  /** Returns the number of frames that did not start at the pose where the last one ended. */
  public long broken() {
    return broken;
  }

  long compared() {
    return compared;
  }

  /** Returns the number of compared legs on which filter and fractions disagree. */
  long disagreements() {
    return disagreements;
  }

  /** Begins with a tool that was placed. */
  public void begin(ToolMotion motion) {
    begin(motion.pose());
  }

  /** Begins a new chain of legs at a pose at which the tool was set free. */
  public void begin(Pose pose) {
    end.set(pose);
  }

  /**
   * Judges the last frame. The scene must not change after {@link #begin}, so a tool that is set
   * free breaks the chain too.
   */
  public void judge(BodyScene bodies, RigidTool tool, ToolMotion motion) {
    broken += motion.pathPose(0).sameBits(end) ? 0 : 1;
    for (int step = 0; step < motion.steps(); step++) {
      for (int body = 0; body < bodies.count(); body++) {
        bodies.body(body).toolToGrid(motion.pathPose(step), from);
        bodies.body(body).toolToGrid(motion.pathPose(step + 1), to);
        for (int point = 0; point < tool.count(); point++) {
          tool.point(point, position);
          judge(bodies, body);
        }
      }
    }
    end.set(motion.pose());
  }

  private void judge(BodyScene bodies, int body) {
    Vec3 p = position;
    ray.from(from.x(p.x, p.y, p.z), from.y(p.x, p.y, p.z), from.z(p.x, p.y, p.z));
    ray.to(to.x(p.x, p.y, p.z), to.y(p.x, p.y, p.z), to.z(p.x, p.y, p.z));
    boolean touches = judge.touches(bodies.body(body).bits(), ray);
    legs++;
    touching += touches ? 1 : 0;
    if (compared < mostCompared) {
      compared++;
      boolean agrees = touches == reference.touches(bodies.body(body).bits(), ray);
      disagreements += agrees ? 0 : 1;
    }
  }
}
