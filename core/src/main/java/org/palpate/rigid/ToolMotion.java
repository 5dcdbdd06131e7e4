package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;

/**
 * The tool's pose and what the last frame did with it. The legs of a frame are the straight
 * segments of each point between one pose of the path and the next. Written by the solver, in the
 * haptic thread.
 */
public final class ToolMotion {
  /** The most steps of one frame. */
  public static final int MOST_STEPS = 16;

  final ToolContacts contacts = new ToolContacts();
  final Pose[] path = new Pose[MOST_STEPS + 1];
  int steps;
  double pathMm;
  boolean contact;
  boolean freed;
  double depthMm;
  int reducedPoints;

  /** Creates the motion of a tool that stands at the identity. */
  public ToolMotion() {
    for (int n = 0; n < path.length; n++) {
      path[n] = new Pose();
    }
  }

  /** Returns the tool pose, tool frame to world, mm; not to be written. */
  public Pose pose() {
    return path[steps];
  }

  /** Returns the number of steps of the last frame; 0 if the tool rested. */
  public int steps() {
    return steps;
  }

  /** Returns the pose before step {@code index}, or after the last step; not to be written. */
  public Pose pathPose(int index) {
    return path[index];
  }

  /** Returns an upper bound of the longest path of a point in the last frame, mm. */
  public double pathMm() {
    return pathMm;
  }

  /** Whether a solid kept the tool from its device pose at the end of the frame. */
  public boolean contact() {
    return contact;
  }

  /** Returns the contacts that hold the tool back; none without {@link #contact}. */
  public ToolContacts contacts() {
    return contacts;
  }

  /** Writes the position of the sample point of a contact of {@code tool}, world mm. */
  public Vec3 contactMm(int contact, RigidTool tool, Vec3 dest) {
    return pose().transform(tool.point(contacts.point(contact), dest), dest);
  }

  /** Whether the tool was set free in the last frame; then the path has a single pose. */
  public boolean freed() {
    return freed;
  }

  /** Returns how far below the isosurface the contacts run, mm. */
  public double depthMm() {
    return depthMm;
  }

  /**
   * Returns the number of points that keep less than the full clearance of some body. As long as it
   * is not 0, the whole-tool theorem does not hold.
   */
  public int reducedPoints() {
    return reducedPoints;
  }

  /** Leaves the tool where it is for a frame in which no solver moves it. */
  public void rest() {
    path[0].set(path[steps]);
    steps = 0;
    pathMm = 0;
    freed = false;
  }

  boolean isFull() {
    return steps == MOST_STEPS;
  }

  void add(Pose pose, double lengthMm) {
    path[++steps].set(pose);
    pathMm += lengthMm;
  }

  void placeAt(Pose pose) {
    steps = 0;
    pathMm = 0;
    contacts.clear();
    path[0].set(pose);
  }
}
