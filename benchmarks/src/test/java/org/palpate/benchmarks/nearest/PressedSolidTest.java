package org.palpate.benchmarks.nearest;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Vec3;
import org.palpate.volume.phantom.AnalyticSurface;

/** The surfaces that {@code bench} presses on, against differences and searches. */
class PressedSolidTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_129);
  private static final double STEP = 1e-5;

  private final SplittableRandom random = new SplittableRandom(SEED);

  private Vec3 anywhere() {
    return new Vec3(
        random.nextDouble(PressedSolid.EDGE),
        random.nextDouble(PressedSolid.EDGE),
        random.nextDouble(PressedSolid.EDGE));
  }

  @Test
  void aVoxelIsSolidIfItsCentreIsNotOutside() {
    for (PressedSolid solid : PressedSolid.all()) {
      int inside = 0;
      for (int n = 0; n < 5_000; n++) {
        int i = random.nextInt(PressedSolid.EDGE);
        int j = random.nextInt(PressedSolid.EDGE);
        int k = random.nextInt(PressedSolid.EDGE);
        double height = solid.truth().signedDistance(new Vec3(i + 0.5, j + 0.5, k + 0.5));
        assertEquals(height <= 0, solid.bits().get(i, j, k), solid.shape());
        inside += height <= 0 ? 1 : 0;
      }
      assertTrue(inside > 500 && inside < 4_500, solid.shape() + " " + inside);
    }
  }

  /** The normal is the gradient of the distance, and the gradient of a distance has length 1. */
  @Test
  void aNormalIsTheGradientOfTheDistance() {
    for (PressedSolid solid : PressedSolid.all()) {
      AnalyticSurface truth = solid.truth();
      int smooth = 0;
      for (int n = 0; n < 200; n++) {
        Vec3 at = anywhere();
        Vec3 gradient = gradient(truth, at);
        if (Math.abs(gradient.length() - 1) < 1e-4) {
          smooth++;
          Vec3 normal = truth.normal(at, new Vec3());
          assertEquals(0, normal.sub(gradient, new Vec3()).length(), 1e-3, solid.shape() + at);
        }
      }
      assertTrue(smooth > 190, solid.shape() + ": " + smooth);
    }
  }

  private static Vec3 gradient(AnalyticSurface truth, Vec3 at) {
    Vec3 gradient = new Vec3();
    for (int axis = 0; axis < 3; axis++) {
      Vec3 more = new Vec3().set(at);
      Vec3 less = new Vec3().set(at);
      more.set(axis, at.get(axis) + STEP);
      less.set(axis, at.get(axis) - STEP);
      double rise = truth.signedDistance(more) - truth.signedDistance(less);
      gradient.set(axis, rise / (2 * STEP));
    }
    return gradient;
  }

  /** No point of the surface is nearer than the distance, and the nearest one is about as near. */
  @Test
  void aDistanceInsideIsThatToTheNearestOfManySurfacePoints() {
    for (PressedSolid solid : PressedSolid.all()) {
      AnalyticSurface truth = solid.truth();
      List<Vec3> surface = surfacePoints(truth);
      for (int n = 0; n < 40; n++) {
        Vec3 at = anywhere();
        double height = truth.signedDistance(at);
        if (height > 0) {
          continue; // beside an edge of a box the distance outside is only a bound
        }
        double nearest = Double.POSITIVE_INFINITY;
        for (Vec3 point : surface) {
          nearest = Math.min(nearest, point.sub(at, new Vec3()).length());
        }
        assertTrue(nearest > -height - 1e-6, solid.shape() + ": a point is nearer");
        Vec3 foot = new Vec3();
        truth.normal(at, foot).mul(-height, foot).add(at, foot);
        assertEquals(0, truth.signedDistance(foot), 1e-9, solid.shape() + ": the nearest point");
      }
    }
  }

  /** Finds where lines between random positions cross the surface. */
  private List<Vec3> surfacePoints(AnalyticSurface truth) {
    List<Vec3> points = new ArrayList<>();
    while (points.size() < 500) {
      Vec3 inside = anywhere();
      Vec3 outside = anywhere();
      if (truth.signedDistance(inside) < 0 && truth.signedDistance(outside) > 0) {
        for (int halving = 0; halving < 60; halving++) {
          Vec3 middle = inside.add(outside, new Vec3());
          middle.mul(0.5, middle);
          (truth.signedDistance(middle) < 0 ? inside : outside).set(middle);
        }
        points.add(inside);
      }
    }
    return points;
  }

  @Test
  void theShapesAreBoxesBallsCylindersAndPlanesAndEndInsideTheGridOrAcrossIt() {
    List<String> shapes = PressedSolid.all().stream().map(PressedSolid::shape).distinct().toList();
    assertEquals(List.of("box", "ball", "cylinder", "tilted plane"), shapes);
    Vec3 middle = new Vec3(56, 56, 56);
    for (PressedSolid solid : PressedSolid.all()) {
      double height = solid.truth().signedDistance(middle);
      if (solid.shape().equals("tilted plane")) {
        assertTrue(Math.abs(height) < 1, "a plane passes near the middle: " + height);
      } else {
        assertTrue(height < -30, solid.shape() + " holds the middle: " + height);
      }
    }
  }

  @Test
  void theSizesOfBoxAndBallAreThoseOfTheirFormulas() {
    AnalyticSurface box = PressedSolid.all().get(0).truth();
    assertEquals(-44, box.signedDistance(new Vec3(56, 56, 56)));
    assertEquals(-2, box.signedDistance(new Vec3(14, 56, 50)));
    assertEquals(5, box.signedDistance(new Vec3(50, 105, 60)));
    assertEquals(new Vec3(-1, 0, 0).toString(), box.normal(new Vec3(14, 56, 50), new Vec3()) + "");
    assertEquals(new Vec3(0, 1, 0).toString(), box.normal(new Vec3(50, 99, 60), new Vec3()) + "");
    assertEquals(new Vec3(0, 0, -1).toString(), box.normal(new Vec3(50, 50, 13), new Vec3()) + "");
    AnalyticSurface ball = PressedSolid.all().get(3).truth();
    assertEquals(-34.3, ball.signedDistance(new Vec3(56.3, 55.6, 56.1)), 1e-12);
    assertEquals(0, ball.signedDistance(new Vec3(56.3, 55.6, 56.1 - 34.3)), 1e-12);
    AnalyticSurface cylinder = PressedSolid.all().get(4).truth();
    assertEquals(-38.4, cylinder.signedDistance(new Vec3(56.3, 55.6, 3)), 1e-12);
    assertEquals(0, cylinder.signedDistance(new Vec3(56.3 + 38.4, 55.6, 99)), 1e-12);
  }
}
