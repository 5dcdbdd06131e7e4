package org.palpate.scene;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.geometry.Vec3;

/**
 * A plane that hides the surfaces in front of it, so that the inside is seen. Scene frame.
 *
 * @param normal unit; points to the hidden side, on which the viewer is
 * @param point a point of the plane, mm
 */
public record ClipPlane(Vec3 normal, Vec3 point) {
  /**
   * The plane with which a scene begins.
   *
   * @param direction of the plane
   * @param worldMm for a plane across an axis its place on that axis of the world, mm; if empty, it
   *     leads through the interaction point and follows it
   */
  public record Start(Direction direction, OptionalDouble worldMm) {
    /**
     * Checks the place.
     *
     * @throws IllegalArgumentException if a plane has one that lies across no axis
     */
    public Start {
      if (worldMm.isPresent() && !direction.isAcrossAxis()) {
        throw new IllegalArgumentException(
            "only a plane across an axis has a place on it: direction=" + direction);
      }
    }
  }

  /** The direction in which a plane clips. */
  public enum Direction {
    /** No plane. */
    OFF(Direction.NONE),
    /** Across the x axis. */
    X(0),
    /** Across the y axis. */
    Y(1),
    /** Across the z axis. */
    Z(2),
    /** Facing the viewer, also after the view was turned. */
    VIEW(Direction.NONE);

    private static final int NONE = -1;

    private final int axis;

    Direction(int axis) {
      this.axis = axis;
    }

    /** Returns the name as it is written on the command line. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }

    /** Whether planes lie across an axis. */
    public boolean isAcrossAxis() {
      return axis != NONE;
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
        case X, Y, Z -> across(point, camera);
        case VIEW -> Optional.of(new ClipPlane(camera.back(), new Vec3().set(point)));
      };
    }

    /** Returns the axis across which a plane lies: 0 is x, 1 is y, 2 is z. */
    int axis() {
      return axis;
    }

    private Optional<ClipPlane> across(Vec3 point, Camera camera) {
      Vec3 normal = new Vec3();
      normal.set(axis, camera.eye().get(axis) >= point.get(axis) ? 1 : -1);
      return Optional.of(new ClipPlane(normal, new Vec3().set(point)));
    }
  }
}
