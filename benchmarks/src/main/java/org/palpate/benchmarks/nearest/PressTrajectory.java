package org.palpate.benchmarks.nearest;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * Seeded device positions of a hand that presses straight in to a depth, slides a little at that
 * depth, and rests.
 */
final class PressTrajectory {
  private static final double ABOVE = 3;
  private static final double SPEED = 0.3;
  private static final int SLIDES = 30;

  /** The largest distance of the press from the grid's middle; the solids end farther out. */
  private static final double REACH = 10;

  private final PressedSolid solid;
  private final double depth;
  private final List<Vec3> positions = new ArrayList<>();

  private PressTrajectory(PressedSolid solid, double depth) {
    this.solid = solid;
    this.depth = depth;
  }

  /** Returns the positions of the device; it rests at the last one. */
  static List<Vec3> positions(PressedSolid solid, double depth, SplittableRandom random) {
    PressTrajectory press = new PressTrajectory(solid, depth);
    press.approach(random);
    press.slide(random);
    return press.positions;
  }

  private void approach(SplittableRandom random) {
    Vec3 at = new Vec3();
    do {
      at.set(coordinate(random), coordinate(random), coordinate(random));
      moveToHeight(ABOVE, at);
    } while (!isOverOneFace(at));
    for (double height = ABOVE; height > -depth; height -= SPEED) {
      moveToHeight(height, at);
      positions.add(new Vec3().set(at));
    }
    moveToHeight(-depth, at);
    positions.add(at);
  }

  private double coordinate(SplittableRandom random) {
    return 0.5 * PressedSolid.EDGE + 2 * REACH * (random.nextDouble() - 0.5);
  }

  /** Whether the device reaches its depth below the same face. */
  private boolean isOverOneFace(Vec3 at) {
    Vec3 inside = new Vec3().set(at);
    moveToHeight(-depth, inside);
    Vec3 before = solid.truth().normal(at, new Vec3());
    return isAtHeight(-depth, inside)
        && before.dot(solid.truth().normal(inside, new Vec3())) > 1 - 1e-9;
  }

  private boolean isAtHeight(double height, Vec3 at) {
    return Math.abs(solid.truth().signedDistance(at) - height) < 1e-9;
  }

  private void slide(SplittableRandom random) {
    Vec3 heading =
        new Vec3(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
    boolean onSameFace = true;
    for (int step = 0; step < SLIDES && onSameFace; step++) {
      onSameFace = slide(heading);
    }
  }

  /** Slides one step unless it would lead to another face, and returns whether it did. */
  private boolean slide(Vec3 heading) {
    Vec3 at = new Vec3().set(positions.get(positions.size() - 1));
    Vec3 normal = solid.truth().normal(at, new Vec3());
    heading.sub(normal.mul(heading.dot(normal), new Vec3()), heading);
    at.add(heading.mul(SPEED / heading.length(), heading), at);
    moveToHeight(-depth, at);
    boolean onSameFace = normal.dot(solid.truth().normal(at, new Vec3())) > 0.9;
    if (onSameFace) {
      positions.add(at);
    }
    return onSameFace;
  }

  /** Moves along the normal to a height above the surface. */
  private void moveToHeight(double height, Vec3 at) {
    Vec3 normal = new Vec3();
    for (int n = 0; n < 2; n++) {
      solid.truth().normal(at, normal);
      at.add(normal.mul(height - solid.truth().signedDistance(at), normal), at);
    }
  }
}
