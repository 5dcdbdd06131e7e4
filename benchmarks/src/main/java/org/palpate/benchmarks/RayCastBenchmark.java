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

/**
 * Time of one ray against the bits of a ball at 256^3, by caster, length in voxels, and where the
 * ray runs.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class RayCastBenchmark {
  private static final int RAYS = 4096; // fits in a second-level cache, defeats the branch history
  private static final int EDGE = 256;
  private static final long SEED = 11;

  @Param({"exact", "sampled:1", "sampled:0.1", "gridplanes"})
  public String caster;

  /**
   * {@code free}: too far above the surface to meet it; {@code near}: from one voxel above it in
   * any direction; {@code hit}: straight down from half the length above it; {@code anywhere}: from
   * up to thirty voxels above it in any direction; {@code slide}: each ray a small step after the
   * last, just above the surface and along it.
   */
  @Param({"free", "near", "hit", "anywhere", "slide"})
  public String place;

  @Param({"1", "4", "16", "50"})
  public double length;

  private final double[] rays = new double[6 * RAYS];
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final Vec3 start = new Vec3();
  private final Vec3 way = new Vec3();
  private final Vec3 normal = new Vec3();
  private final SplittableRandom random = new SplittableRandom(SEED);
  private SurfaceTruth truth;
  private BitCube bits;
  private RayCaster rayCaster;

  /** Makes the ball and the rays. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse("sphere:" + EDGE);
    bits = phantom.segments().segments().get(0).bits();
    truth = phantom.truth().orElseThrow();
    rayCaster = casterOf(caster);
    for (int n = 0; n < RAYS; n++) {
      aim(n);
      for (int axis = 0; axis < 3; axis++) {
        rays[6 * n + axis] = start.get(axis);
        rays[6 * n + 3 + axis] = start.get(axis) + way.get(axis);
      }
    }
  }

  private static RayCaster casterOf(String name) {
    return switch (name) {
      case "exact" -> new ExactRayCaster();
      case "gridplanes" -> new GridPlanesRayCaster();
      default -> new SampledRayCaster(Double.parseDouble(name.substring("sampled:".length())));
    };
  }

  private void aim(int n) {
    if (n == 0 || !place.equals("slide")) {
      start.set(EDGE * random.nextDouble(), EDGE * random.nextDouble(), EDGE * random.nextDouble());
    } else {
      start.x += 0.1;
      start.y += 0.07;
    }
    lift(
        switch (place) {
          case "free" -> length + 4;
          case "hit" -> length / 2;
          case "anywhere" -> 30 * random.nextDouble();
          default -> 1;
        });
    direct();
  }

  /** Puts the start so far above the surface. */
  private void lift(double above) {
    truth.normal(start, normal);
    start.add(normal.mul(above - truth.signedDistance(start), normal), start);
    truth.normal(start, normal);
  }

  private void direct() {
    if (place.equals("hit")) {
      normal.mul(-length, way);
      return;
    }
    do {
      way.set(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
      if (place.equals("slide")) {
        way.set(0.1, 0.07, 0);
      }
      way.sub(normal.mul(place.equals("slide") ? way.dot(normal) : 0, new Vec3()), way);
    } while (way.length() < 0.05);
    way.mul(length / way.length(), way);
  }

  /** All rays, counted by rays. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int cast() {
    int hits = 0;
    for (int at = 0; at < rays.length; at += 6) {
      ray.from(rays[at], rays[at + 1], rays[at + 2]);
      ray.to(rays[at + 3], rays[at + 4], rays[at + 5]);
      hits += rayCaster.cast(bits, ray, hit) ? 1 : 0;
    }
    return hits;
  }
}
