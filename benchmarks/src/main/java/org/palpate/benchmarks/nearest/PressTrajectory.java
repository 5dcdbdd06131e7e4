package org.palpate.benchmarks.nearest;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.palpate.geometry.Vec3;

/**
 * A hand that comes straight in to a depth, slides a little way at that depth, and rests: device
 * positions, the same for a seed.
 */
final class PressTrajectory {
  private static final double ABOVE = 3;
  private static final double SPEED = 0.3;
  private static final int SLIDES = 30;

  /** How far from the grid's middle a hand may come in; the solids end farther out. */
  private static final double REACH = 10;

  private final PressedSolid solid;
  private final double depth;
  private final List<Vec3> way = new ArrayList<>();

  private PressTrajectory(PressedSolid solid, double depth) {
    this.solid = solid;
    this.depth = depth;
  }

  /** The way of the device, its last position the one that it rests at. */
  static List<Vec3> way(PressedSolid solid, double depth, SplittableRandom random) {
    PressTrajectory press = new PressTrajectory(solid, depth);
    press.comeIn(random);
    press.slide(random);
    return press.way;
  }

  private void comeIn(SplittableRandom random) {
    Vec3 at = new Vec3();
    do {
      at.set(place(random), place(random), place(random));
      keepAt(ABOVE, at);
    } while (!isOverOneFace(at));
    for (double height = ABOVE; height > -depth; height -= SPEED) {
      keepAt(height, at);
      way.add(new Vec3().set(at));
    }
    keepAt(-depth, at);
    way.add(at);
  }

  private double place(SplittableRandom random) {
    return 0.5 * PressedSolid.EDGE + 2 * REACH * (random.nextDouble() - 0.5);
  }

  /** Whether it is as deep under the same face wherever it goes in from here. */
  private boolean isOverOneFace(Vec3 at) {
    Vec3 inside = new Vec3().set(at);
    keepAt(-depth, inside);
    Vec3 before = solid.truth().normal(at, new Vec3());
    return isKeptAt(-depth, inside)
        && before.dot(solid.truth().normal(inside, new Vec3())) > 1 - 1e-9;
  }

  private boolean isKeptAt(double height, Vec3 at) {
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

  /** One step; none where it would come to another face. */
  private boolean slide(Vec3 heading) {
    Vec3 at = new Vec3().set(way.get(way.size() - 1));
    Vec3 normal = solid.truth().normal(at, new Vec3());
    heading.sub(normal.mul(heading.dot(normal), new Vec3()), heading);
    at.add(heading.mul(SPEED / heading.length(), heading), at);
    keepAt(-depth, at);
    boolean onSameFace = normal.dot(solid.truth().normal(at, new Vec3())) > 0.9;
    if (onSameFace) {
      way.add(at);
    }
    return onSameFace;
  }

  /** Moves along the normal to a height over the surface. */
  private void keepAt(double height, Vec3 at) {
    Vec3 normal = new Vec3();
    for (int n = 0; n < 2; n++) {
      solid.truth().normal(at, normal);
      at.add(normal.mul(height - solid.truth().signedDistance(at), normal), at);
    }
  }
}
