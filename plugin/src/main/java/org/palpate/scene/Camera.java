package org.palpate.scene;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * A camera that orbits a target at a distance. Immutable; each move returns a new camera. Scene
 * frame, mm.
 */
public final class Camera {
  /** Visible height at the target over the distance: an angle of view of 28 degrees. */
  public static final double HEIGHT_PER_DISTANCE = 0.5;

  private static final double MARGIN = 1.06;
  private static final double MIN_DISTANCE_MM = 1e-3;

  private final Vec3 target;
  private final Vec3 right;
  private final Vec3 up;
  private final Vec3 back;
  private final double distanceMm;

  private Camera(Vec3 target, Vec3 back, Vec3 upHint, double distanceMm) {
    this.target = target;
    this.back = unit(back);
    right = unit(upHint.cross(this.back, new Vec3()));
    up = this.back.cross(right, new Vec3());
    this.distanceMm = distanceMm;
  }

  /**
   * Returns a camera that sees all of the given points.
   *
   * @param middle the target, scene frame, mm
   * @param points points that must be in the picture, such as the corners of boxes
   * @param aspect width of the picture over its height
   */
  static Camera seeing(Vec3 middle, List<Vec3> points, StandardView view, double aspect) {
    Camera unit = new Camera(new Vec3().set(middle), view.towardsEye(), view.up(), 1);
    double half = HEIGHT_PER_DISTANCE / 2;
    double distance = MIN_DISTANCE_MM;
    for (Vec3 point : points) {
      Vec3 from = point.sub(middle, new Vec3());
      double needed =
          Math.max(
              Math.abs(from.dot(unit.up)) / half, Math.abs(from.dot(unit.right)) / (half * aspect));
      distance = Math.max(distance, from.dot(unit.back) + MARGIN * needed);
    }
    return unit.zoom(distance);
  }

  /** Returns the camera rolled by 180 degrees. */
  public Camera upsideDown() {
    return new Camera(target, back, up.mul(-1, new Vec3()), distanceMm);
  }

  /** Returns the camera after turning the scene to the right and upwards, rad. */
  public Camera orbit(double rightRadians, double upRadians) {
    Vec3 turned = combine(back, Math.cos(rightRadians), right, -Math.sin(rightRadians));
    Vec3 raised = combine(turned, Math.cos(upRadians), up, -Math.sin(upRadians));
    Vec3 newUp = combine(up, Math.cos(upRadians), turned, Math.sin(upRadians));
    return new Camera(target, raised, newUp, distanceMm);
  }

  /** Returns the camera after moving the scene right and up, in picture heights. */
  public Camera pan(double rightHeights, double upHeights) {
    double height = distanceMm * HEIGHT_PER_DISTANCE;
    Vec3 moved = combine(right, -rightHeights * height, up, -upHeights * height);
    return new Camera(moved.add(target, moved), back, up, distanceMm);
  }

  /** Returns the camera with its distance multiplied by a factor. */
  public Camera zoom(double factor) {
    return new Camera(target, back, up, distanceMm * factor);
  }

  /** Returns the position of the camera. */
  public Vec3 eye() {
    return combine(target, 1, back, distanceMm);
  }

  /**
   * Returns the position of an eye.
   *
   * @param eye 0 for a single eye, -1 for the left and 1 for the right of two
   */
  public Vec3 eye(int eye) {
    return combine(eye(), 1, right, eye * eyeShiftMm());
  }

  /** Returns the unit vector to the right of the picture. Read-only, as the other axes. */
  public Vec3 right() {
    return right;
  }

  /** Returns the unit vector to the top of the picture. */
  public Vec3 up() {
    return up;
  }

  /** Returns the unit vector from the target to the viewer. */
  public Vec3 back() {
    return back;
  }

  /**
   * Returns the axes of the picture in the world: right, up and towards the viewer. They mirror if
   * the world is left-handed.
   */
  public RigidTransform axes(WorldAxes world) {
    return new RigidTransform(
        world.toSceneOrBack(right, new Vec3()),
        world.toSceneOrBack(up, new Vec3()),
        world.toSceneOrBack(back, new Vec3()),
        new Vec3());
  }

  /**
   * Returns the rotation by which a drag over the picture turns the scene. The side that faces the
   * viewer moves in the direction of the drag.
   *
   * @param right the drag to the right, in heights of the picture; one height is half a turn
   * @param up the drag upwards, in heights of the picture
   * @param world the axes of the world
   * @return the rotation vector, world axes, rad
   */
  public Vec3 dragRotation(double right, double up, WorldAxes world) {
    return turn(new Vec3(-Math.PI * up, Math.PI * right, 0), world);
  }

  /**
   * Returns in the world a turn as the viewer sees it.
   *
   * @param seen the rotation vector along the axes right, up and towards the viewer, rad
   * @param world the axes of the world
   * @return the rotation vector, world axes, rad
   */
  public Vec3 turn(Vec3 seen, WorldAxes world) {
    RigidTransform picture = axes(world);
    Vec3 turned = picture.rotate(seen, new Vec3());
    return turned.mul(picture.isMirrored() ? -1 : 1, turned);
  }

  /** Returns the distance from the target. */
  public double distanceMm() {
    return distanceMm;
  }

  /**
   * Returns the view matrix of an eye.
   *
   * @param eye 0 for a single eye, -1 for the left and 1 for the right of two
   */
  public Matrix4 view(int eye) {
    return Matrix4.view(right, up, back, eye(eye));
  }

  /**
   * Returns the projection matrix of an eye, with near and far planes around a ball of {@code
   * radiusMm}.
   */
  public Matrix4 perspective(int eye, double aspect, Vec3 middle, double radiusMm) {
    double depth = back.dot(eye().sub(middle, new Vec3()));
    double far = Math.max(depth + 1.2 * radiusMm, 0.02 * radiusMm);
    double near = Math.max(depth - 1.2 * radiusMm, 0.004 * far);
    double halfWidth = HEIGHT_PER_DISTANCE / 2 * aspect;
    double shift = -eye * eyeShiftMm() / (distanceMm * halfWidth);
    return Matrix4.perspective(HEIGHT_PER_DISTANCE, aspect, near, far, shift);
  }

  /** Returns half the distance between two eyes: a thirtieth of the distance to the target. */
  private double eyeShiftMm() {
    return distanceMm / 30;
  }

  private static Vec3 combine(Vec3 a, double factorA, Vec3 b, double factorB) {
    return new Vec3(
        a.x * factorA + b.x * factorB,
        a.y * factorA + b.y * factorB,
        a.z * factorA + b.z * factorB);
  }

  private static Vec3 unit(Vec3 vector) {
    return vector.mul(1 / vector.length(), new Vec3());
  }
}
