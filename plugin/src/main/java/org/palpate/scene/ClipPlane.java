package org.palpate.scene;

import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.Vec3;

/**
 * A plane that hides the surfaces in front of it, so that the inside is seen. Scene frame.
 *
 * @param normal unit; points to the hidden side, on which the viewer is
 * @param point a point of the plane, mm
 */
public record ClipPlane(Vec3 normal, Vec3 point) {
  /** The direction in which a plane clips. */
  public enum Direction {
    /** No plane. */
    OFF,
    /** Across the x axis. */
    X,
    /** Across the y axis. */
    Y,
    /** Across the z axis. */
    Z,
    /** Facing the viewer, also after the view was turned. */
    VIEW;

    /** Returns the name as it is written on the command line. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }

    /** Returns the direction that follows, and after the last one the first. */
    Direction next() {
      return switch (this) {
        case OFF -> X;
        case X -> Y;
        case Y -> Z;
        case Z -> VIEW;
        case VIEW -> OFF;
      };
    }

    /** Returns the plane through a point, seen by a camera; empty if there is none. */
    Optional<ClipPlane> through(Vec3 point, Camera camera) {
      return switch (this) {
        case OFF -> Optional.empty();
        case X -> across(0, point, camera);
        case Y -> across(1, point, camera);
        case Z -> across(2, point, camera);
        case VIEW -> Optional.of(new ClipPlane(camera.back(), new Vec3().set(point)));
      };
    }

    private static Optional<ClipPlane> across(int axis, Vec3 point, Camera camera) {
      Vec3 normal = new Vec3();
      normal.set(axis, camera.eye().get(axis) >= point.get(axis) ? 1 : -1);
      return Optional.of(new ClipPlane(normal, new Vec3().set(point)));
    }
  }
}
