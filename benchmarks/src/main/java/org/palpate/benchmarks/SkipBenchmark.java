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
import org.palpate.force.ContactForce;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.GuardedSolver;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.Metric;
import org.palpate.proxy.Obstacles;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.SurfaceTruth;

/**
 * What each thing that is skipped is worth: time with the skip and without, where it helps and
 * where it does not. Objects that are far have {@link ManyObjectsBenchmark}.
 *
 * <ul>
 *   <li>{@code empty bricks}: a ray; helps over 50 voxels of mostly empty space, not at length 4
 *       one voxel above a surface.
 *   <li>{@code memory}: a pressed frame of {@code guarded} that remembers fruitless climbs,
 *       neighbours and where it rested; helps at 0.05 voxel a frame, not at 2.
 *   <li>{@code rest}: the same where the device rests in every frame but one of a hundred; does not
 *       help where it moves in each.
 *   <li>{@code friction}: a force; helps in frames that touch nothing, not in those that slide.
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
  private static final double DEPTH = 5;
  private static final long SEED = 7;
  private static final Metric METRIC = new Metric(1, 1, 1);

  @Param({"empty bricks", "memory", "rest", "friction"})
  public String skip;

  @Param({"helps", "does not help"})
  public String scene;

  @Param({"with", "without"})
  public String way;

  private final GuardedSolver solver = new GuardedSolver(METRIC, 8);
  private final InteractionPoint point = new InteractionPoint();
  private final Vec3 device = new Vec3();
  private final Vec3 force = new Vec3();
  private RaySet rays;
  private ExactRayCaster caster;
  private ContactForce contactForce;
  private BitCube bits;
  private Obstacles obstacles;
  private Trajectory trajectory;
  private boolean with;
  private boolean helps;

  /** Makes a ball and the hand. */
  @Setup
  public void prepare() {
    with = way.equals("with");
    helps = scene.equals("helps");
    Phantom phantom = Phantom.parse("sphere:" + EDGE);
    SurfaceTruth truth = phantom.truth().orElseThrow();
    bits = phantom.segments().segments().get(0).bits();
    obstacles = new Obstacles(List.of(bits));
    caster = new ExactRayCaster(with);
    double speed = helps ? 0.05 : skip.equals("memory") ? 2 : 0.2;
    boolean touches = !skip.equals("friction") || !helps;
    trajectory = Trajectories.slide(truth, EDGE, touches ? DEPTH : -DEPTH, speed, FRAMES, SEED);
    contactForce =
        new ContactForce(METRIC, new ForceSettings(0.5, 0.2, FrictionForm.EQUATION_4, with));
    rays = RaySet.of(truth, EDGE, helps ? "anywhere" : "near", helps ? 50 : 4, FRAMES, SEED);
  }

  /** A frame, or a ray. */
  @Benchmark
  @OperationsPerInvocation(FRAMES)
  public double frames() {
    return switch (skip) {
      case "empty bricks" -> rays.hits(caster, bits);
      case "memory" -> follow(1);
      case "rest" -> follow(helps ? 100 : 1);
      case "friction" -> forces();
      default -> throw new IllegalArgumentException("no such skip: " + skip);
    };
  }

  /** Each place of the device for so many frames. */
  private double follow(int framesEach) {
    trajectory.at(0, point.position);
    solver.reset();
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.at(frame / framesEach, device);
      if (!with) {
        solver.reset(); // forgets all that was kept from the last frame
      }
      solver.follow(obstacles, device, point);
      sum += point.position.x;
    }
    return sum;
  }

  private double forces() {
    trajectory.at(0, point.position);
    solver.reset();
    double sum = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      trajectory.at(frame, device);
      solver.follow(obstacles, device, point);
      contactForce.compute(point, device, force);
      sum += force.x;
    }
    return sum;
  }
}
