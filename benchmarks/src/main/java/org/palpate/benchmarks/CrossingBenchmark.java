package org.palpate.benchmarks;

import java.util.concurrent.TimeUnit;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.device.DeviceState;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.device.jni.NativeDevice;
import org.palpate.device.jni.NativeLibrary;
import org.palpate.geometry.Vec3;

/**
 * Cost of a frame's calls to C++: a read and a write of the {@code empty} device, against two
 * native calls that do nothing. The paper lost 0.26 us per frame.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class CrossingBenchmark {
  private final DeviceState state = new DeviceState();
  private final Vec3 forceNewton = new Vec3(1, 2, 3);
  private final Vec3 torqueNewtonMm = new Vec3(30, 20, 10);
  private NativeDevice device;

  /** Opens the device. */
  @Setup
  public void open() throws DeviceException {
    device = DeviceCatalog.open("empty", "");
  }

  /** Closes the device. */
  @TearDown
  public void close() {
    device.close();
  }

  /** Makes the two calls of a frame. */
  @Benchmark
  public boolean readAndWrite() {
    device.read(state);
    return device.write(forceNewton, torqueNewtonMm);
  }

  /** Makes two calls that do nothing. */
  @Benchmark
  public void twoEmptyCalls() {
    NativeLibrary.callNothing();
    NativeLibrary.callNothing();
  }
}
