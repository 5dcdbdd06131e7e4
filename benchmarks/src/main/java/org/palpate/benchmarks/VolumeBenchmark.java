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
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.volume.BitCube;
import org.palpate.volume.phantom.Phantom;

/** Reading and editing bits of the head phantom at 256^3. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class VolumeBenchmark {
  private static final int EDGE = 256;
  private static final int VOXELS = 4096;
  private static final long SEED = 13;

  private final int[] places = new int[VOXELS];
  private BitCube bits;

  /** Makes the phantom and places in it. */
  @Setup
  public void prepare() {
    bits = Phantom.parse("head:" + EDGE).segments().segments().get(0).bits();
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < VOXELS; n++) {
      places[n] = random.nextInt(EDGE * EDGE * EDGE);
    }
  }

  /** Looks at voxels at random. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public int readVoxel() {
    int solid = 0;
    for (int place : places) {
      solid += bits.get(place & 255, place >> 8 & 255, place >> 16) ? 1 : 0;
    }
    return solid;
  }

  /** Looks at the 4x4x4 voxels from a voxel on, at random. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public long readWindow() {
    long all = 0;
    for (int place : places) {
      all ^= bits.window(place & 255, place >> 8 & 255, place >> 16);
    }
    return all;
  }

  /** Makes voxels solid and empty again, at random: two edits an operation. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public long editVoxelTwice() {
    for (int place : places) {
      int i = place & 255;
      int j = place >> 8 & 255;
      int k = place >> 16;
      if (bits.get(i, j, k)) {
        bits.clear(i, j, k);
        bits.set(i, j, k);
      } else {
        bits.set(i, j, k);
        bits.clear(i, j, k);
      }
    }
    return bits.solidCount();
  }
}
