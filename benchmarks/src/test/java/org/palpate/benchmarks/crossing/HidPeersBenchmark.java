package org.palpate.benchmarks.crossing;

import com.sun.jna.Pointer;
import java.util.concurrent.TimeUnit;
import org.hid4java.jna.HidApi;
import org.hid4java.jna.HidDeviceStructure;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.device.DeviceState;
import org.palpate.device.jni.DeviceCatalog;
import org.palpate.device.jni.DeviceException;
import org.palpate.device.jni.NativeDevice;
import org.palpate.device.jni.NativeLibrary;
import org.palpate.geometry.Vec3;

/**
 * Cost of a frame's access to a HID device: two reads (a report, then none) and a write of one,
 * over the same substitute of hidapi without hardware. Palpate also unpacks, orders and limits; the
 * others only move bytes. Run by {@code src/test/sh/crossing-table.sh}.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(3) // the compiled code of a native call differs from one JVM to the next
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 3, time = 1)
public class HidPeersBenchmark {
  private static final String NULL_PATH = "null:";
  private static final int IN_BYTES = 48;
  private static final int OUT_BYTES = 24;

  private final DeviceState state = new DeviceState();
  private final Vec3 forceNewton = new Vec3(0.1, 0.2, 0.3);
  private final Vec3 torqueNewtonMm = new Vec3(30, 20, 10);
  private final byte[] in = new byte[IN_BYTES];
  private final byte[] out = new byte[OUT_BYTES];
  private NativeDevice device;
  private NativeDevice empty;
  private Pointer jna;
  private HidDeviceStructure peer;

  /** Opens the device through each library. */
  @Setup
  public void open() throws DeviceException {
    device = DeviceCatalog.open("hid", "NULL");
    empty = DeviceCatalog.open("empty", "");
    jna = JnaHidapi.hid_open_path(NULL_PATH);
    HidApi.init();
    peer = HidApi.open(NULL_PATH);
    if (jna == null || peer == null) {
      throw new IllegalStateException("no " + NULL_PATH + ": set PALPATE_NULL_HID");
    }
  }

  /** Uses Palpate: one native call to read and one to write. */
  @Benchmark
  public boolean palpate() {
    device.read(state);
    return device.write(forceNewton, torqueNewtonMm);
  }

  /** Uses Palpate without a device, not even hidapi. */
  @Benchmark
  public boolean palpateEmpty() {
    empty.read(state);
    return empty.write(forceNewton, torqueNewtonMm);
  }

  /** Uses JNA with direct mapping. */
  @Benchmark
  public int jnaDirect() {
    int got = JnaHidapi.hid_read_timeout(jna, in, IN_BYTES, 0);
    got += JnaHidapi.hid_read_timeout(jna, in, IN_BYTES, 0);
    return got + JnaHidapi.hid_write(jna, out, OUT_BYTES);
  }

  /** Uses hid4java, which maps an interface by JNA. */
  @Benchmark
  public int hid4java() {
    int got = HidApi.read(peer, in, 0);
    got += HidApi.read(peer, in, 0);
    return got + HidApi.write(peer, out, OUT_BYTES, (byte) 2);
  }

  /** Makes two native calls that do nothing. */
  @Benchmark
  public void twoEmptyCalls() {
    NativeLibrary.callNothing();
    NativeLibrary.callNothing();
  }
}
