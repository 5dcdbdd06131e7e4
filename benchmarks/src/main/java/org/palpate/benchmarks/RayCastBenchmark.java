package org.palpate.benchmarks;

import java.util.SplittableRandom;
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
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;
import org.palpate.volume.phantom.SurfaceTruth;

/** Time of one ray against the bits of a ball at 256^3, by caster and by where the ray runs. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class RayCastBenchmark {
  private static final int RAYS = 4096; // fits in a second-level cache, defeats the branch history
  private static final long SEED = 11;

  @Param({"exact", "sampled:1", "sampled:0.1", "gridplanes"})
  public String caster;

  private final double[] freeShort = new double[6 * RAYS];
  private final double[] nearSurface = new double[6 * RAYS];
  private final double[] anywhere = new double[6 * RAYS];
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private BitCube bits;
  private RayCaster rayCaster;

  /** Makes the ball and the rays. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse("sphere:256");
    bits = phantom.segments().segments().get(0).bits();
    rayCaster = casterOf(caster);
    SplittableRandom random = new SplittableRandom(SEED);
    SurfaceTruth truth = phantom.truth().orElseThrow();
    for (int n = 0; n < RAYS; n++) {
      putRay(freeShort, n, random, truth, 20, 1);
      putRay(nearSurface, n, random, truth, 1, 4);
      putRay(anywhere, n, random, truth, 30 * random.nextDouble(), 50);
    }
  }

  private static RayCaster casterOf(String name) {
    return switch (name) {
      case "exact" -> new ExactRayCaster();
      case "gridplanes" -> new GridPlanesRayCaster();
      default -> new SampledRayCaster(Double.parseDouble(name.substring("sampled:".length())));
    };
  }

  /** A ray of a length in any direction, from a point so far above the surface. */
  private static void putRay(
      double[] rays,
      int n,
      SplittableRandom random,
      SurfaceTruth truth,
      double above,
      double length) {
    Vec3 direction = new Vec3();
    do {
      direction.set(
          random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
    } while (direction.length() < 0.05);
    direction.mul(length / direction.length(), direction);
    Vec3 start =
        new Vec3(256 * random.nextDouble(), 256 * random.nextDouble(), 256 * random.nextDouble());
    double offset = above - truth.signedDistance(start);
    Vec3 normal = truth.normal(start, new Vec3());
    start.add(normal.mul(offset, normal), start);
    for (int axis = 0; axis < 3; axis++) {
      rays[6 * n + axis] = start.get(axis);
      rays[6 * n + 3 + axis] = start.get(axis) + direction.get(axis);
    }
  }

  /** Length 1, twenty voxels above the surface: nothing to meet. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int throughEmptyBricks() {
    return castAll(freeShort);
  }

  /** Length 4, from one voxel above the surface. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int nearTheSurface() {
    return castAll(nearSurface);
  }

  /** Length 50, from up to thirty voxels above the surface. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int farAndAnywhere() {
    return castAll(anywhere);
  }

  private int castAll(double[] rays) {
    int hits = 0;
    for (int at = 0; at < rays.length; at += 6) {
      ray.from(rays[at], rays[at + 1], rays[at + 2]);
      ray.to(rays[at + 3], rays[at + 4], rays[at + 5]);
      hits += rayCaster.cast(bits, ray, hit) ? 1 : 0;
    }
    return hits;
  }
}
