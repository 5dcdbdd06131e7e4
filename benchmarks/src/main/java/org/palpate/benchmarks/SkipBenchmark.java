package org.palpate.benchmarks;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.benchmarks.input.RaySet;
import org.palpate.benchmarks.input.Trajectories;
import org.palpate.collision.CollisionScene;
import org.palpate.device.Trajectory;
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolverVariants;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.ExactRayCasterVariants;
import org.palpate.sync.Accumulator;
import org.palpate.sync.TouchProperties;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.AnalyticSurface;
import org.palpate.volume.phantom.Phantom;

/**
 * The gain of each skip: time with and without it, where it helps and where it does not. {@link
 * ManyObjectsBenchmark} measures far objects, and {@code bench --skips} what the scene skips.
 *
 * <ul>
 *   <li>{@code empty bricks}: a ray; helps over 50 voxels of mostly empty space, not at length 4
 *       one voxel above a surface.
 *   <li>{@code neighbours}: a pressed frame of {@code guarded} that caches the neighbourhoods of
 *       the last frames; helps at 0.05 voxel per frame, less at 2.
 *   <li>{@code climbs}: the same frame, which remembers steps up that failed.
 *   <li>{@code rest}: the same frame with a device that moves once in a hundred frames; does not
 *       help if it moves in each.
 *   <li>{@code response}: a pressed frame of collision alone, against {@code guarded}; helps less
 *       without contact.
 *   <li>{@code friction}: frame and force of a pressed hand; helps if mu is 0.
 *   <li>{@code properties}: the published properties of a frame; helps if none changed.
 * </ul>
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class SkipBenchmark {
  private static final int FRAMES = 20_000;
  private static final int EDGE = 256;
  private static final int FRAMES_AT_REST = 100;
  private static final double DEPTH = 5;
  private static final double MAX_STEP_VOXELS = 8;
  private static final long SEED = 7;
  private static final GridMetric METRIC = new GridMetric(1, 1, 1);

  @Param({"empty bricks", "neighbours", "climbs", "rest", "response", "friction", "properties"})
  public String skip;

  @Param({"helps", "does not help"})
  public String scene;

  @Param({"with", "without"})
  public String way;

  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();
  private RaySet rays;
  private ProxySolver solver;
  private ExactRayCaster caster;
  private ContactForce contactForce;
  private TouchProperties properties;
  private BitCube bits;
  private CollisionScene obstacles;
  private Trajectory trajectory;
  private boolean with;
  private boolean helps;

  /** Makes a ball and the hand. */
  @Setup
  public void prepare() {
    with = way.equals("with");
    helps = scene.equals("helps");
    Phantom phantom = Phantom.parse("sphere:" + EDGE);
    AnalyticSurface truth = phantom.analyticSurface().orElseThrow();
    bits = phantom.segments().segments().get(0).bits();
    obstacles = new CollisionScene(List.of(bits));
    caster = with ? new ExactRayCaster() : ExactRayCasterVariants.voxelByVoxel();
    rays = RaySet.of(truth, EDGE, helps ? "anywhere" : "near", helps ? 50 : 4, FRAMES, SEED);
    boolean touches = helps || !skip.equals("response");
    trajectory = Trajectories.slide(truth, EDGE, touches ? DEPTH : -DEPTH, speed(), FRAMES, SEED);
    double friction = helps ? 0 : 0.2;
    contactForce =
        new ContactForce(METRIC, new ForceSettings(0.5, friction, FrictionForm.EQUATION_4, with));
    properties = new TouchProperties(with ? new Accumulator() : Accumulator.withoutSkipping());
    solver = solver();
  }

  private double speed() {
    boolean isMemory = skip.equals("neighbours") || skip.equals("climbs");
    return !isMemory ? 0.2 : helps ? 0.05 : 2;
  }

  private ProxySolver solver() {
    if (skip.equals("response") && with) {
      return new CollisionOnlySolver(new ExactRayCaster(), METRIC);
    }
    return GuardedSolverVariants.skippingOnly(
        METRIC,
        MAX_STEP_VOXELS,
        with || !skip.equals("neighbours"),
        with || !skip.equals("climbs"),
        with || !skip.equals("rest"));
  }

  /** Runs frames, rays or publications. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double frames() {
    return switch (skip) {
      case "empty bricks" -> rays.hits(caster, bits);
      case "neighbours", "climbs", "response" -> follow(1);
      case "rest" -> follow(helps ? FRAMES_AT_REST : 1);
      case "friction" -> forces();
      case "properties" -> publish();
      default -> throw new IllegalArgumentException("no such skip: " + skip);
    };
  }

  private void begin() {
    trajectory.position(0, point.position);
    solver.reset();
  }

  /** Follows each position of the device for a number of frames. */
  private double follow(int framesEach) {
    begin();
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      solver.follow(obstacles, trajectory.position(frame / framesEach, device), point);
      sum += point.position.x;
    }
    return sum;
  }

  private double forces() {
    begin();
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      solver.follow(obstacles, trajectory.position(frame, device), point);
      contactForce.compute(point, device, force);
      sum += force.x;
    }
    return sum;
  }

  private double publish() {
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.position(helps ? 0 : frame, device);
      properties.publish(device, device, device, true, frame);
    }
    return device.x;
  }
}
