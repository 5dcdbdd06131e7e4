package org.palpate.io.volume;

import java.util.Optional;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/** Converts positions between worlds whose axes point to opposite sides of the patient. */
public final class AxisSigns {
  private AxisSigns() {}

  /**
   * Returns the sign by which each coordinate changes from one world to the other; empty if the
   * directions of exactly one of them are not known.
   */
  public static Optional<Vec3> between(CoordinateSystem from, CoordinateSystem to) {
    if (from == to) {
      return Optional.of(new Vec3(1, 1, 1));
    }
    if (from == CoordinateSystem.UNKNOWN || to == CoordinateSystem.UNKNOWN) {
      return Optional.empty();
    }
    return Optional.of(apply(toLps(from), toLps(to)));
  }

  private static Vec3 toLps(CoordinateSystem system) {
    return switch (system) {
      case RAS -> new Vec3(-1, -1, 1);
      case LAS -> new Vec3(1, -1, 1);
      case LPS, UNKNOWN -> new Vec3(1, 1, 1);
    };
  }

  /**
   * Returns a grid with its axes turned from one world into another; empty if the directions of
   * exactly one of them are not known.
   */
  public static Optional<VoxelGrid> convert(
      VoxelGrid grid, CoordinateSystem from, CoordinateSystem to) {
    RigidTransform t = grid.gridMmToWorld();
    return between(from, to)
        .map(
            signs ->
                new VoxelGrid(
                    grid.sizeX(),
                    grid.sizeY(),
                    grid.sizeZ(),
                    grid.spacingMm(),
                    new RigidTransform(
                        apply(signs, t.axisX()),
                        apply(signs, t.axisY()),
                        apply(signs, t.axisZ()),
                        apply(signs, t.origin()))));
  }

  /** Returns a position or direction with the signs of its coordinates changed. */
  private static Vec3 apply(Vec3 signs, Vec3 v) {
    return new Vec3(signs.x * v.x, signs.y * v.y, signs.z * v.z);
  }
}
