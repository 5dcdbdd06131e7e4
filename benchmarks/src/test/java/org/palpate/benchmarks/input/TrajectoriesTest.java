package org.palpate.benchmarks.input;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.LongFunction;
import org.junit.jupiter.api.Test;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

class TrajectoriesTest {
  private static final int EDGE = 64;
  private static final int FRAMES = 3_000;
  private static final long SEED = 5;

  private final AnalyticSurface ball =
      Phantom.parse("sphere:" + EDGE).analyticSurface().orElseThrow();

  private double height(Trajectory hand, int frame) {
    return ball.signedDistance(hand.position(frame, new Vec3()));
  }

  private static double step(Trajectory hand, int frame) {
    Vec3 before = hand.position(frame - 1, new Vec3());
    return hand.position(frame, new Vec3()).sub(before, before).length();
  }

  @Test
  void theSeedAloneDecidesOnEveryTrajectory() {
    List<LongFunction<Trajectory>> all =
        List.of(
            seed -> Trajectories.slide(ball, EDGE, 3, 0.5, 300, seed),
            seed -> Trajectories.approach(ball, EDGE, 3, 0.5, 300, seed),
            seed -> Trajectories.grooves(ball, EDGE, 3, 0.5, 300, seed),
            seed -> Trajectories.free(ball, EDGE, 3, 0.5, 300, seed),
            seed -> Trajectories.jumps(EDGE, EDGE, EDGE, 300, seed),
            seed -> Trajectories.wander(EDGE, EDGE, EDGE, 2, 300, seed));
    for (LongFunction<Trajectory> kind : all) {
      Trajectory hand = kind.apply(SEED);
      Trajectory same = kind.apply(SEED);
      Trajectory other = kind.apply(SEED + 1);
      assertEquals(300, hand.size());
      int differing = 0;
      for (int frame = 0; frame < 300; frame++) {
        Vec3 at = hand.position(frame, new Vec3());
        assertTrue(at.isFinite());
        assertTrue(at.sameBits(same.position(frame, new Vec3())));
        differing += at.sameBits(other.position(frame, new Vec3())) ? 0 : 1;
      }
      assertTrue(differing > 290, "kind " + all.indexOf(kind) + " differing=" + differing);
    }
  }

  @Test
  void aSlideComesDownAndStaysAtItsDepthWithinTheGrid() {
    Trajectory hand = Trajectories.slide(ball, EDGE, 3, 0.5, FRAMES, SEED);
    assertEquals(5.5, height(hand, 0), 1e-9);
    for (int frame = 1; frame < FRAMES; frame++) {
      double expected = Math.max(-3, 5.5 - 0.5 * frame);
      assertEquals(expected, height(hand, frame), 1e-9, "frame=" + frame);
      assertTrue(step(hand, frame) < 0.5 + 1e-9, "frame=" + frame);
      Vec3 at = hand.position(frame, new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        assertTrue(at.get(axis) > 0 && at.get(axis) < EDGE);
      }
    }
    double moved = 0;
    for (int frame = 100; frame < FRAMES; frame++) {
      moved += step(hand, frame) / (FRAMES - 100);
    }
    assertTrue(moved > 0.4, "the hand slides and does not rest: " + moved);
  }

  @Test
  void aFreeHandStaysAboveTheSurface() {
    Trajectory hand = Trajectories.free(ball, EDGE, 1, 0.12, FRAMES, SEED);
    for (int frame = 0; frame < FRAMES; frame++) {
      assertTrue(height(hand, frame) > 1 - 1e-9, "frame=" + frame);
      assertTrue(frame == 0 || step(hand, frame) < 0.5 + 1e-9, "frame=" + frame);
    }
    assertEquals(1, height(hand, FRAMES - 1), 1e-9);
  }

  @Test
  void anApproachGoesInToItsDepthAndOutAgainElsewhere() {
    Trajectory hand = Trajectories.approach(ball, EDGE, 3, 0.5, FRAMES, SEED);
    int turns = 0;
    int elsewhere = 0;
    for (int frame = 1; frame < FRAMES - 1; frame++) {
      double height = height(hand, frame);
      assertTrue(height > -3 - 1e-9 && height < 6 + 1e-9, "height=" + height);
      turns += height < -3 + 1e-9 ? 1 : 0;
      if (step(hand, frame) > 0.5 + 1e-9) {
        elsewhere++;
        assertEquals(6, height, 1e-9);
        assertEquals(5.5, height(hand, frame - 1), 1e-9, "it went all the way out before");
      } else {
        assertEquals(0.5, step(hand, frame), 1e-9, "frame=" + frame);
      }
    }
    assertTrue(Math.abs(36 * turns - FRAMES) <= 36, "18 frames in, 18 out: " + turns);
    assertEquals(turns, elsewhere, 1);
  }

  @Test
  void aRakeReturnsOverTheSameGroove() {
    Trajectory hand = Trajectories.grooves(ball, EDGE, 2, 0.5, FRAMES, SEED);
    Vec3 first = hand.position(0, new Vec3());
    double farthest = 0;
    for (int frame = 1; frame < FRAMES; frame++) {
      assertEquals(-2, height(hand, frame), 1e-9);
      assertTrue(step(hand, frame) < 0.5 + 1e-9);
      farthest =
          Math.max(farthest, hand.position(frame, new Vec3()).sub(first, new Vec3()).length());
    }
    assertTrue(farthest > 12 && farthest < 25, "farthest=" + farthest);
  }

  @Test
  void jumpsAreNoLongerThanFiftyVoxelsAndReachAllOfTheGridAndItsRim() {
    Trajectory hand = Trajectories.jumps(200, 100, 50, FRAMES, SEED);
    double longest = 0;
    double mean = 0;
    Vec3 low = new Vec3(999, 999, 999);
    Vec3 high = new Vec3(-999, -999, -999);
    for (int frame = 1; frame < FRAMES; frame++) {
      longest = Math.max(longest, step(hand, frame));
      mean += step(hand, frame) / FRAMES;
      Vec3 at = hand.position(frame, new Vec3());
      for (int axis = 0; axis < 3; axis++) {
        low.set(axis, Math.min(low.get(axis), at.get(axis)));
        high.set(axis, Math.max(high.get(axis), at.get(axis)));
      }
    }
    assertTrue(longest < 50 && longest > 45, "longest=" + longest);
    assertTrue(mean > 15, "mean=" + mean);
    double[] sizes = {200, 100, 50};
    for (int axis = 0; axis < 3; axis++) {
      assertTrue(low.get(axis) >= -0.05 * sizes[axis] && low.get(axis) < 0);
      assertTrue(high.get(axis) <= 1.05 * sizes[axis] && high.get(axis) > sizes[axis]);
    }
  }

  @Test
  void aWanderKeepsItsSpeedButForTheStepsThatReachAGoal() {
    Trajectory hand = Trajectories.wander(100, 100, 100, 2, FRAMES, SEED);
    int shorter = 0;
    for (int frame = 1; frame < FRAMES; frame++) {
      double step = step(hand, frame);
      assertTrue(step < 2 + 1e-9, "step=" + step);
      shorter += step < 2 - 1e-9 ? 1 : 0;
    }
    assertTrue(shorter > 20 && shorter < FRAMES / 10, "shorter=" + shorter);
  }

  @Test
  void aSurfaceFromWithinLiesAVoxelDeeperAndFacesTheOtherWay() {
    AnalyticSurface within = Trajectories.fromWithin(ball);
    Vec3 at = new Vec3(32, 40, 47);
    assertEquals(-ball.signedDistance(at) - 1, within.signedDistance(at));
    Vec3 normal = ball.normal(at, new Vec3());
    assertEquals(-1, within.normal(at, new Vec3()).dot(normal), 1e-12);
  }

  private RaySet rays(String kind, double length) {
    return RaySet.of(ball, EDGE, kind, length, 500, SEED);
  }

  @Test
  void everyKindOfRayHasItsLengthAndItsStart() {
    Ray ray = new Ray();
    for (String kind : List.of("free", "near", "hit", "anywhere", "slide")) {
      RaySet rays = rays(kind, 7);
      assertEquals(500, rays.count());
      for (int n = 0; n < rays.count(); n++) {
        rays.at(n, ray);
        double length =
            Math.sqrt(
                square(ray.toX - ray.fromX)
                    + square(ray.toY - ray.fromY)
                    + square(ray.toZ - ray.fromZ));
        assertEquals(7, length, 1e-9, kind);
        double height = ball.signedDistance(new Vec3(ray.fromX, ray.fromY, ray.fromZ));
        switch (kind) {
          case "free" -> assertEquals(11, height, 1e-9);
          case "near" -> assertEquals(1, height, 1e-9);
          case "hit" -> assertEquals(3.5, height, 1e-9);
          case "anywhere" -> assertTrue(height > -1e-9 && height < 30);
          default -> assertTrue(height > 1 - 1e-9 && height < 6);
        }
      }
    }
  }

  private static double square(double x) {
    return x * x;
  }

  @Test
  void raysThatAreFreeHitNothingAndRaysThatHitDoSo() {
    BitCube bits = Phantom.parse("sphere:" + EDGE).segments().segments().get(0).bits();
    ExactRayCaster caster = new ExactRayCaster();
    assertEquals(0, rays("free", 7).hits(caster, bits));
    assertEquals(500, rays("hit", 7).hits(caster, bits));
    int near = rays("near", 7).hits(caster, bits);
    assertTrue(near > 100 && near < 400, "near=" + near);
  }

  @Test
  void theSeedAloneDecidesOnTheRaysAndAnUnknownKindIsRefused() {
    Ray one = rays("anywhere", 7).at(499, new Ray());
    Ray same = rays("anywhere", 7).at(499, new Ray());
    Ray other = RaySet.of(ball, EDGE, "anywhere", 7, 500, SEED + 1).at(499, new Ray());
    assertEquals(one.toString(), same.toString());
    assertFalse(one.toString().equals(other.toString()));
    IllegalArgumentException refused =
        assertThrows(IllegalArgumentException.class, () -> rays("sideways", 7));
    assertEquals("no such kind of ray: sideways", refused.getMessage());
  }
}
