package org.palpate.benchmarks.stress;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.palpate.benchmarks.stress.StressSession.Attacked;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

/** Checks the units in which the work of a frame is bounded. */
class WorkCountsTest {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);

  private static BitCube floor() {
    BitCube bits = new BitCube(32, 32, 32);
    for (int n = 0; n < 32 * 32; n++) {
      for (int k = 0; k < 8; k++) {
        bits.set(n % 32, n / 32, k);
      }
    }
    return bits;
  }

  private static WorkCounts above(Attacked solver) {
    return new WorkCounts(solver, floor(), UNIT, 8, new Vec3(16.5, 16.5, 20.5));
  }

  @ParameterizedTest
  @EnumSource
  void eachFrameHasItsOwnCount(Attacked solver) {
    WorkCounts counts = above(solver);
    for (int frame = 0; frame < 1_100; frame++) {
      counts.follow(new Vec3(16.5 + 0.001 * frame, 16.5, frame < 500 ? 20.5 : 3.5));
    }
    long[] all = counts.result().counts();
    assertEquals(1_100, all.length, "more frames than there is room for at first");
    long free = max(all, 100, 500);
    assertTrue(free < 50, "a frame in empty space counts its own work alone: " + free);
    long pressed = max(all, 500, 1_100);
    assertTrue(free < pressed, "free " + free + ", pressed " + pressed);
    assertTrue(counts.position().z >= 8 && counts.position().z < 9, "" + counts.position());
  }

  @Test
  void theWorkOfAFrameIsItsStepsAndTheWordsThatItReads() {
    WorkCounts counts = above(Attacked.GUARDED);
    CountingCube bits = new CountingCube(floor());
    CollisionScene scene = new CollisionScene(List.of(bits));
    GuardedSolver solver = new GuardedSolver(UNIT, 8);
    InteractionPoint point = new InteractionPoint();
    point.position.set(16.5, 16.5, 20.5);
    long steps = 0;
    for (int frame = 0; frame < 60; frame++) {
      Vec3 device = new Vec3(16.5 + 0.3 * frame % 9, 16.5, 20.5 - 0.3 * frame);
      counts.follow(device);
      long before = bits.words();
      solver.follow(scene, device, point);
      assertEquals(solver.steps() + bits.words() - before, counts.result().counts()[frame]);
      steps += solver.steps();
    }
    assertTrue(steps > 60 && bits.words() > 60, steps + " steps, " + bits.words() + " words");
  }

  @ParameterizedTest
  @EnumSource
  void theSameFramesHaveTheSameWork(Attacked solver) {
    WorkCounts one = above(solver);
    WorkCounts other = above(solver);
    for (int frame = 0; frame < 200; frame++) {
      Vec3 device = new Vec3(16.5 + frame % 7, 16.5 - frame % 5, frame % 20);
      one.follow(device);
      other.follow(device);
    }
    assertArrayEquals(one.result().counts(), other.result().counts());
  }

  @ParameterizedTest
  @EnumSource
  void aClearedVoxelIsFeltInTheNextFrame(Attacked solver) {
    WorkCounts counts = above(solver);
    Vec3 device = new Vec3(16.5, 16.5, 3.5);
    for (int frame = 0; frame < 20; frame++) {
      counts.follow(device);
    }
    double before = counts.position().z;
    for (int n = 0; n < 25; n++) {
      for (int k = 4; k < 8; k++) {
        counts.clear(14 + n % 5, 14 + n / 5, k);
      }
    }
    for (int frame = 0; frame < 20; frame++) {
      counts.follow(device);
    }
    assertTrue(counts.position().z < before - 3, before + " and then " + counts.position());
  }

  @Test
  void aFrameWithoutMotionInEmptySpaceIsNearlyFree() {
    WorkCounts counts = above(Attacked.GUARDED);
    for (int frame = 0; frame < 3; frame++) {
      counts.follow(new Vec3(16.5, 16.5, 20.5));
    }
    assertTrue(counts.result().counts()[2] <= 1, "work " + counts.result().counts()[2]);
  }

  private static long max(long[] all, int from, int to) {
    long most = 0;
    for (int n = from; n < to; n++) {
      most = Math.max(most, all[n]);
    }
    return most;
  }
}
