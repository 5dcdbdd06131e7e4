package org.palpate.benchmarks.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;

class ShellPoolTest {
  private static final int ROUNDS = 50;

  @ParameterizedTest
  @ValueSource(ints = {1, 2, 3, 7})
  void everyRoundWorksOnEveryPointOnce(int threads) {
    try (ShellPool pool = new ShellPool(threads)) {
      for (int points : new int[] {0, 1, 63, 64, 65, 1000}) {
        int[] times = new int[points];
        for (int round = 0; round < ROUNDS; round++) {
          int worked = pool.run(points, (thread, from, to) -> count(times, from, to));
          assertEquals(points, worked);
        }
        assertEquals((long) ROUNDS * points, Arrays.stream(times).sum());
        assertEquals(points == 0 ? 0 : ROUNDS, Arrays.stream(times).max().orElse(0));
      }
    }
  }

  private static int count(int[] times, int from, int to) {
    for (int point = from; point < to; point++) {
      times[point]++;
    }
    return to - from;
  }

  @Test
  void aFailureOfAWorkerReachesTheCallerAndThePoolContinues() {
    try (ShellPool pool = new ShellPool(3)) {
      assertThrows(IllegalStateException.class, () -> pool.run(300, ShellPoolTest::failElsewhere));
      assertEquals(300, pool.run(300, (thread, from, to) -> to - from));
    }
  }

  private static int failElsewhere(int thread, int from, int to) {
    if (thread > 0) {
      throw new IllegalArgumentException("thread=" + thread);
    }
    return to - from;
  }

  @Test
  void threeThreadsMoveTheShellAsOneThreadDoes() {
    BitCube floor = new BitCube(32, 32, 8);
    for (int n = 0; n < 32 * 32; n++) {
      floor.set(n % 32, n / 32, n % 5 % 3);
    }
    double[] toolMm = new double[3 * 400];
    for (int n = 0; n < toolMm.length; n++) {
      toolMm[n] = n * 7919 % 1000 / 50.0;
    }
    double[] alone = slide(floor, toolMm, 1);
    assertEquals(Arrays.toString(alone), Arrays.toString(slide(floor, toolMm, 3)));
  }

  private static double[] slide(BitCube bits, double[] toolMm, int threads) {
    GridMetric metric = new GridMetric(1, 1, 1);
    PointShell shell = new PointShell(toolMm);
    Vec3 origin = new Vec3(3, 3, 9);
    RigidTransform pose =
        new RigidTransform(new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), origin);
    ShellResponse response =
        new ShellResponse(shell.count(), metric, () -> new GuardedSolver(metric, 8));
    CollisionScene[] views = new CollisionScene[threads];
    Arrays.setAll(views, thread -> new CollisionScene(List.of(bits)));
    shell.place(pose, metric);
    response.place(views[0], shell);
    try (ShellPool pool = new ShellPool(threads)) {
      for (int frame = 0; frame < 100; frame++) {
        origin.set(3 + 0.05 * frame, 3 + 0.03 * frame, 9 - 0.2 * frame);
        shell.place(pose, metric);
        pool.run(
            shell.count(), (thread, from, to) -> response.follow(views[thread], shell, from, to));
      }
    }
    double[] positions = new double[3 * shell.count()];
    for (int n = 0; n < positions.length; n++) {
      positions[n] = response.point(n / 3).position.get(n % 3);
    }
    return positions;
  }
}
