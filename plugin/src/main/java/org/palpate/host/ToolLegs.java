package org.palpate.host;

import java.io.IOException;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.BodyMotions;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.RigidTool;

/**
 * Lists the legs of a tool's points in a frame. They are computed from the poses that the solver
 * committed, and equal the verified legs bit for bit. One thread.
 */
public final class ToolLegs {
  private final BodyScene bodies;
  private final RigidTool tool;
  private final AffineMap[] maps;
  private final Vec3 start = new Vec3();
  private final Vec3 end = new Vec3();

  /** Receives legs. */
  @FunctionalInterface
  public interface LegSink {
    /**
     * Receives a leg. The vectors belong to the list and change with the next leg.
     *
     * @param leg its number among the legs of this point and body in the frame, from 0; {@link
     *     #RELEASED} if the tool was set free, with the same start and end
     * @param body index of the body
     * @param point index of the tool's point
     * @param start grid coordinates of the body
     * @param end grid coordinates of the body
     * @throws IOException if the leg cannot be written
     */
    void accept(int leg, int body, int point, Vec3 start, Vec3 end) throws IOException;
  }

  /** The number of a leg at which the tool is set free and a new chain begins. */
  public static final int RELEASED = -1;

  /**
   * Makes a list for a tool among bodies.
   *
   * @param bodies the bodies, in the order of their indices
   * @param tool the sample points of the tool
   */
  public ToolLegs(BodyScene bodies, RigidTool tool) {
    this.bodies = bodies;
    this.tool = tool;
    maps = new AffineMap[ToolMotion.MOST_STEPS + bodies.count() + 1];
    for (int n = 0; n < maps.length; n++) {
      maps[n] = new AffineMap();
    }
  }

  /**
   * Lists the legs of the last frame: by body, then by point, then in time. A point at rest
   * relative to a body has no leg.
   *
   * @param motion the motion of the last frame
   * @param freed whether the tool was set free, so that each point begins with a release
   * @param every only points whose index is divisible by this, at least 1
   * @param sink receives each leg
   * @throws IOException if the receiver fails to write a leg
   */
  public void list(ToolMotion motion, boolean freed, int every, LegSink sink) throws IOException {
    for (int b = 0; b < bodies.count(); b++) {
      int steps = setMaps(motion, b);
      for (int point = 0; point < tool.count(); point += every) {
        listPoint(steps, freed, b, point, sink);
      }
    }
  }

  /**
   * Writes the maps from the tool to the grid of a body before and after each step in which one of
   * the two moved. First bodies move, and may push the tool; then the tool follows its device.
   *
   * @return the number of steps
   */
  private int setMaps(ToolMotion motion, int b) {
    Body body = bodies.body(b);
    BodyMotions moved = motion.bodies();
    Pose bodyPose = poseBefore(moved, b);
    Pose toolPose = motion.pathPose(0);
    int steps = 0;
    body.toolToGrid(bodyPose, toolPose, maps[0]);
    for (int n = 0; n < moved.count(); n++) {
      int toolStep = moved.toolStep(n);
      if (toolStep != BodyMotions.NO_STEP) {
        toolPose = motion.pathPose(toolStep + 1);
      }
      if (moved.body(n) == b) {
        bodyPose = moved.to(n);
      }
      body.toolToGrid(bodyPose, toolPose, maps[++steps]);
    }
    for (int step = motion.pushes(); step < motion.steps(); step++) {
      body.toolToGrid(bodyPose, motion.pathPose(step + 1), maps[++steps]);
    }
    return steps;
  }

  private Pose poseBefore(BodyMotions moved, int b) {
    for (int n = 0; n < moved.count(); n++) {
      if (moved.body(n) == b) {
        return moved.from(n);
      }
    }
    return bodies.body(b).pose();
  }

  private void listPoint(int steps, boolean freed, int body, int point, LegSink sink)
      throws IOException {
    maps[0].transform(tool.point(point, start), start);
    if (freed) {
      sink.accept(RELEASED, body, point, start, start);
    }
    int leg = 0;
    for (int step = 0; step < steps; step++) {
      maps[step + 1].transform(tool.point(point, end), end);
      if (!end.sameBits(start)) {
        sink.accept(leg++, body, point, start, end);
        start.set(end);
      }
    }
  }

  /**
   * {@return the longest path of a point in the last frame, world mm}
   *
   * @param motion the motion of the last frame
   * @param held the points of the tool, or of the body that is held
   */
  public double longestPathMm(ToolMotion motion, RigidTool held) {
    double longest = 0;
    for (int point = 0; motion.steps() > 0 && point < held.count(); point++) {
      double length = 0;
      for (int step = 0; step < motion.steps(); step++) {
        motion.pathPose(step).transform(held.point(point, start), start);
        motion.pathPose(step + 1).transform(held.point(point, end), end);
        length += end.sub(start, end).length();
      }
      longest = Math.max(longest, length);
    }
    return longest;
  }
}
