package org.palpate.benchmarks.speed;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.collision.NearestFreeVoxel;
import org.palpate.device.Trajectory;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.phantom.Phantom;

/**
 * Times of the slowest frames against typical ones: a device that jumps 50 voxels per frame through
 * a maze, and slides over a ball. A frame's time is the minimum over many passes of the same
 * trajectory, which give the same bits, so that disturbances of the machine drop out. The time of
 * reading the clock is subtracted.
 */
final class FrameTails {
  private static final GridMetric UNIT = new GridMetric(1, 1, 1);
  private static final int FRAMES = 20_000;
  private static final int PASSES = 40;
  private static final double MAX_STEP_VOXELS = 8;
  private static final double JUMP_VOXELS = 50;
  private static final double SLIDE_DEPTH = 5;
  private static final double[] SLIDE_SPEEDS = {0.3, 2};
  private static final double[] PERCENTILES = {50, 99, 99.9, 100};
  private static final long SEED = 7;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();

  /** Measures a row for each percentile of each trajectory. */
  List<SpeedRow> rows() {
    List<SpeedRow> rows = new ArrayList<>();
    Phantom maze = Phantom.parse("maze:128");
    rows.addAll(
        percentiles(
            "jumps in a maze",
            maze,
            Trajectories.wander(maze.edge(), maze.edge(), maze.edge(), JUMP_VOXELS, FRAMES, SEED)));
    Phantom ball = Phantom.parse("sphere:256");
    for (double speed : SLIDE_SPEEDS) {
      rows.addAll(
          percentiles(
              "slide on a ball at " + NumberText.display(speed),
              ball,
              Trajectories.slide(
                  ball.analyticSurface().orElseThrow(),
                  ball.edge(),
                  SLIDE_DEPTH,
                  speed,
                  FRAMES,
                  SEED)));
    }
    return rows;
  }

  private List<SpeedRow> percentiles(
      String trajectoryName, Phantom phantom, Trajectory trajectory) {
    CollisionScene scene =
        new CollisionScene(
            phantom.segments().segments().stream().map(segment -> segment.bits()).toList());
    long[] minNanos = new long[FRAMES];
    Arrays.fill(minNanos, Long.MAX_VALUE);
    for (int pass = 0; pass < PASSES; pass++) {
      follow(scene, trajectory, minNanos);
    }
    long clock = clockNanos();
    Arrays.sort(minNanos);
    List<SpeedRow> rows = new ArrayList<>();
    for (double percentile : PERCENTILES) {
      int at = Math.min(FRAMES - 1, (int) (FRAMES * percentile / 100));
      Map<String, String> condition = new LinkedHashMap<>();
      condition.put("way", trajectoryName);
      condition.put("share", percentile == 100 ? "worst" : percentile + " %");
      List<Double> one = List.of((double) Math.max(0, minNanos[at] - clock));
      rows.add(new SpeedRow("tails", "frame", condition, "ns/op", one, Double.NaN));
    }
    return rows;
  }

  private void follow(CollisionScene scene, Trajectory trajectory, long[] minNanos) {
    GuardedSolver solver = new GuardedSolver(UNIT, MAX_STEP_VOXELS);
    trajectory.position(0, point.position);
    if (scene.touches(point.position.x, point.position.y, point.position.z)) {
      new NearestFreeVoxel(UNIT).find(scene, point.position, point.position);
    }
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.position(frame, device);
      long began = System.nanoTime();
      solver.follow(scene, device, point);
      minNanos[frame] = Math.min(minNanos[frame], System.nanoTime() - began);
    }
  }

  /** Returns the minimum time of two clock readings. */
  private static long clockNanos() {
    long minNanos = Long.MAX_VALUE;
    for (int n = 0; n < FRAMES; n++) {
      long began = System.nanoTime();
      minNanos = Math.min(minNanos, System.nanoTime() - began);
    }
    return minNanos;
  }
}
