package org.palpate.rigid;

import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;

/**
 * The tool's pose and what the last frame did with it. The legs of a frame are the straight
 * segments of each point between one pose of the path and the next. Written by the solver, in the
 * haptic thread.
 */
public final class ToolMotion {
  /** The most steps of one frame. */
  public static final int MOST_STEPS = 24;

  /** The most steps that follow the device. */
  private static final int MOST_FOLLOWING = 16;

  final ToolContacts contacts = new ToolContacts();
  final Pose[] path = new Pose[MOST_STEPS + 1];
  final BodyMotions bodies;
  int steps;
  int pushes;
  double pathMm;
  boolean contact;
  boolean freed;
  double depthMm;
  int reducedPoints;

  /** Creates the motion of a tool that stands at the identity, among bodies that stand still. */
  public ToolMotion() {
    this(0);
  }

  /**
   * Creates the motion of a tool that stands at the identity.
   *
   * @param bodyCount the number of bodies in the scene
   */
  public ToolMotion(int bodyCount) {
    bodies = new BodyMotions(bodyCount);
    for (int n = 0; n < path.length; n++) {
      path[n] = new Pose();
    }
  }

  /** {@return the tool pose, tool frame to world, mm; not to be written} */
  public Pose pose() {
    return path[steps];
  }

  /** {@return the number of steps of the last frame; 0 if the tool rested} */
  public int steps() {
    return steps;
  }

  /**
   * {@return the number of steps that bodies pushed the tool} They come first; the others follow
   * the device.
   */
  public int pushes() {
    return pushes;
  }

  /** {@return the motions of bodies in the last frame, which came before the tool followed} */
  public BodyMotions bodies() {
    return bodies;
  }

  /**
   * {@return a pose of the path; not to be written}
   *
   * @param index the number of the step before which it is, or the number of steps for the last
   *     pose
   */
  public Pose pathPose(int index) {
    return path[index];
  }

  /** {@return an upper bound of the longest path of a point in the last frame, mm} */
  public double pathMm() {
    return pathMm;
  }

  /** {@return whether a solid kept the tool from its device pose at the end of the frame} */
  public boolean contact() {
    return contact;
  }

  /** {@return the contacts that hold the tool back; none without {@link #contact}} */
  public ToolContacts contacts() {
    return contacts;
  }

  /**
   * Writes where a contact touches the tool.
   *
   * @param contact the number of the contact, from 0
   * @param dest receives the position, world mm
   * @return {@code dest}
   */
  public Vec3 contactMm(int contact, Vec3 dest) {
    return pose().transform(contacts.position(contact, dest), dest);
  }

  /** {@return whether the tool was set free in the last frame; then the path has a single pose} */
  public boolean freed() {
    return freed;
  }

  /** {@return how far below the isosurface the contacts run, mm} */
  public double depthMm() {
    return depthMm;
  }

  /**
   * {@return the number of points that keep less than the full clearance of some body} As long as
   * it is not 0, the whole-tool theorem does not hold.
   */
  public int reducedPoints() {
    return reducedPoints;
  }

  /** Leaves the tool where it is for a frame in which no solver moves it. */
  public void rest() {
    path[0].set(path[steps]);
    steps = 0;
    pushes = 0;
    pathMm = 0;
    freed = false;
    bodies.clear();
  }

  boolean isFull() {
    return steps - pushes == MOST_FOLLOWING;
  }

  /** Whether a body can push the tool once more in this frame. */
  boolean canBePushed() {
    return pushes < MOST_STEPS - MOST_FOLLOWING;
  }

  /** Whether the tool has taken a step after the device in this frame. */
  boolean hasFollowed() {
    return steps > pushes;
  }

  void addPush(Pose pose, double lengthMm) {
    add(pose, lengthMm);
    pushes = steps;
  }

  /** Withdraws the steps that followed the device; the tool must stand at the pose before them. */
  void withdraw(double pathMmBefore) {
    steps = pushes;
    pathMm = pathMmBefore;
  }

  void add(Pose pose, double lengthMm) {
    path[++steps].set(pose);
    pathMm += lengthMm;
  }

  void placeAt(Pose pose) {
    steps = 0;
    pushes = 0;
    bodies.clear();
    pathMm = 0;
    contacts.clear();
    path[0].set(pose);
  }
}
