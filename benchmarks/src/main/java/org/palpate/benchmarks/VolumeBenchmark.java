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

/** Time to read and edit bits of the head phantom at 256^3. */
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

  private final int[] voxels = new int[VOXELS];
  private BitCube bits;

  /** Makes the phantom and random voxel numbers. */
  @Setup
  public void prepare() {
    bits = Phantom.parse("head:" + EDGE).segments().segments().get(0).bits();
    SplittableRandom random = new SplittableRandom(SEED);
    for (int n = 0; n < VOXELS; n++) {
      voxels[n] = random.nextInt(EDGE * EDGE * EDGE);
    }
  }

  /** Reads random voxels. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public int readVoxel() {
    int solid = 0;
    for (int voxel : voxels) {
      solid += bits.get(voxel & 255, voxel >> 8 & 255, voxel >> 16) ? 1 : 0;
    }
    return solid;
  }

  /** Reads the 4x4x4 voxels that start at random voxels. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public long readWindow() {
    long all = 0;
    for (int voxel : voxels) {
      all ^= bits.window(voxel & 255, voxel >> 8 & 255, voxel >> 16);
    }
    return all;
  }

  /** Toggles random voxels twice: two edits per operation. */
  @Benchmark
  @OperationsPerInvocation(VOXELS)
  public long editVoxelTwice() {
    for (int voxel : voxels) {
      int i = voxel & 255;
      int j = voxel >> 8 & 255;
      int k = voxel >> 16;
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
