package org.palpate.benchmarks;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.benchmarks.shell.PointShell;
import org.palpate.benchmarks.shell.ShellCollider;
import org.palpate.benchmarks.shell.ShellContacts;
import org.palpate.benchmarks.shell.ShellPool;
import org.palpate.benchmarks.shell.ShellResponse;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Time of one frame of a tool of many points: a ball of radius 20 that slides over a ball of bits
 * at 256^3, 10 voxels deep, and turns. At 1 kHz a frame has 1,000 us.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MICROSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class PointShellBenchmark {
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);
  private static final double MAX_STEP_VOXELS = 8;
  private static final double TOOL_RADIUS = 20;
  private static final double DEPTH = 10;
  private static final double SPEED_VOXELS = 0.2;
  private static final long SEED = 5;

  /** The number of points; the paper reaches 20,000 for collision and 3,000 for response. */
  @Param({"20000", "3000"})
  public int points;

  /** The number of threads; the first is the caller's. */
  @Param({"1", "2"})
  public int threads;

  private final Vec3 axisX = new Vec3(1, 0, 0);
  private final Vec3 axisY = new Vec3(0, 1, 0);
  private final Vec3 origin = new Vec3();
  private final RigidTransform pose = new RigidTransform(axisX, axisY, new Vec3(0, 0, 1), origin);
  private CollisionScene[] views;
  private ShellCollider[] colliders;
  private PointShell shell;
  private ShellContacts contacts;
  private ShellResponse response;
  private ShellPool pool;
  private ShellPool.RangeTask collide;
  private ShellPool.RangeTask respond;
  private double orbitRadius;
  private long frame;

  /** Makes the ball, the tool and the pool. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse("sphere:256");
    BitCube bits = phantom.segments().segments().get(0).bits();
    double ballRadius =
        -phantom.analyticSurface().orElseThrow().signedDistance(new Vec3(128, 128, 128));
    orbitRadius = ballRadius + TOOL_RADIUS - DEPTH;
    views = new CollisionScene[threads];
    Arrays.setAll(views, thread -> new CollisionScene(List.of(bits)));
    colliders = new ShellCollider[threads];
    Arrays.setAll(colliders, thread -> new ShellCollider());
    shell = new PointShell(ball(points));
    contacts = new ShellContacts(points);
    response = new ShellResponse(points, METRIC, () -> new GuardedSolver(METRIC, MAX_STEP_VOXELS));
    pool = new ShellPool(threads);
    collide = this::collide;
    respond = this::respond;
    move();
    shell.place(pose, METRIC);
    response.place(views[0], shell);
  }

  /** Stops the pool. */
  @TearDown
  public void end() {
    pool.close();
  }

  /** Returns random points on the surface of a ball. */
  private static double[] ball(int points) {
    SplittableRandom random = new SplittableRandom(SEED);
    double[] mm = new double[3 * points];
    Vec3 point = new Vec3();
    for (int n = 0; n < points; n++) {
      do {
        point.set(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
      } while (point.length() > 1 || point.length() < 0.1);
      point.mul(TOOL_RADIUS / point.length(), point);
      mm[3 * n] = point.x;
      mm[3 * n + 1] = point.y;
      mm[3 * n + 2] = point.z;
    }
    return mm;
  }

  private void move() {
    frame++;
    double along = SPEED_VOXELS * frame / orbitRadius;
    origin.set(128 + orbitRadius * Math.cos(along), 128 + orbitRadius * Math.sin(along), 128.3);
    double turned = 2e-4 * frame;
    axisX.set(Math.cos(turned), Math.sin(turned), 0);
    axisY.set(-Math.sin(turned), Math.cos(turned), 0);
  }

  private int collide(int thread, int from, int to) {
    shell.place(pose, METRIC, from, to);
    return colliders[thread].cast(views[thread], shell, from, to, contacts);
  }

  private int respond(int thread, int from, int to) {
    shell.place(pose, METRIC, from, to);
    return response.follow(views[thread], shell, from, to);
  }

  /** Computes only contact flags and hits. */
  @Benchmark
  public int collision() {
    move();
    shell.turn();
    return pool.run(points, collide);
  }

  /** Moves an interaction point for each point of the tool. */
  @Benchmark
  public int response() {
    move();
    shell.turn();
    return pool.run(points, respond);
  }
}
