package org.palpate.benchmarks;

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
import org.palpate.benchmarks.baseline.PlainRayCaster;
import org.palpate.benchmarks.input.RaySet;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.SampledRayCaster;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/**
 * Time of one ray against the bits of a ball at 256^3, by caster, by length in voxels and by the
 * kind of ray.
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

  /** The caster; {@code plain:1} skips nothing, see {@link PlainRayCaster}. */
  @Param({"exact", "plain:1", "sampled:1", "sampled:0.1", "gridplanes"})
  public String caster;

  /** The kind of ray, see {@link RaySet#of}. */
  @Param({"free", "near", "hit", "anywhere", "slide"})
  public String place;

  @Param({"1", "4", "16", "50"})
  public double length;

  private RaySet rays;
  private BitCube bits;
  private RayCaster rayCaster;

  /** Makes the ball and the rays. */
  @Setup
  public void prepare() {
    Phantom phantom = Phantom.parse("sphere:" + EDGE);
    bits = phantom.segments().segments().get(0).bits();
    rays = RaySet.of(phantom.analyticSurface().orElseThrow(), EDGE, place, length, RAYS, SEED);
    rayCaster = casterOf(caster, bits);
  }

  private static RayCaster casterOf(String name, BitCube bits) {
    return switch (name) {
      case "exact" -> new ExactRayCaster();
      case "plain:1" -> new PlainRayCaster(bits);
      case "gridplanes" -> new GridPlanesRayCaster();
      default -> new SampledRayCaster(Double.parseDouble(name.substring("sampled:".length())));
    };
  }

  /** Casts all rays. */
  @Benchmark
  @OperationsPerInvocation(RAYS)
  public int cast() {
    return rays.hits(rayCaster, bits);
  }
}
