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
 * How much longer the worst frames take than usual ones: a device that jumps 50 voxels in every
 * frame through a maze, beside slides over a ball. A frame's time is the least of many passes over
 * the same way, which is the same to the bit each time, so that what else the machine did is not in
 * it; less what reading the clock takes.
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

  /** A row for each percentile of each way. */
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
              "slide on a ball at " + NumberText.people(speed),
              ball,
              Trajectories.slide(
                  ball.truth().orElseThrow(), ball.edge(), SLIDE_DEPTH, speed, FRAMES, SEED)));
    }
    return rows;
  }

  private List<SpeedRow> percentiles(String way, Phantom phantom, Trajectory trajectory) {
    CollisionScene obstacles =
        new CollisionScene(
            phantom.segments().segments().stream().map(segment -> segment.bits()).toList());
    long[] least = new long[FRAMES];
    Arrays.fill(least, Long.MAX_VALUE);
    for (int pass = 0; pass < PASSES; pass++) {
      follow(obstacles, trajectory, least);
    }
    long clock = clockNanos();
    Arrays.sort(least);
    List<SpeedRow> rows = new ArrayList<>();
    for (double percentile : PERCENTILES) {
      int at = Math.min(FRAMES - 1, (int) (FRAMES * percentile / 100));
      Map<String, String> condition = new LinkedHashMap<>();
      condition.put("way", way);
      condition.put("share", percentile == 100 ? "worst" : percentile + " %");
      List<Double> one = List.of((double) Math.max(0, least[at] - clock));
      rows.add(new SpeedRow("tails", "frame", condition, "ns/op", one, Double.NaN));
    }
    return rows;
  }

  private void follow(CollisionScene obstacles, Trajectory trajectory, long[] least) {
    GuardedSolver solver = new GuardedSolver(UNIT, MAX_STEP_VOXELS);
    trajectory.position(0, point.position);
    if (obstacles.touches(point.position.x, point.position.y, point.position.z)) {
      new NearestFreeVoxel(UNIT).find(obstacles, point.position, point.position);
    }
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.position(frame, device);
      long began = System.nanoTime();
      solver.follow(obstacles, device, point);
      least[frame] = Math.min(least[frame], System.nanoTime() - began);
    }
  }

  /** What two looks at the clock take at least. */
  private static long clockNanos() {
    long least = Long.MAX_VALUE;
    for (int n = 0; n < FRAMES; n++) {
      long began = System.nanoTime();
      least = Math.min(least, System.nanoTime() - began);
    }
    return least;
  }
}
