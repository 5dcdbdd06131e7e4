package org.palpate.app.command;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.StringJoiner;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.palpate.app.output.Report;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.device.jni.DeviceCounters;
import org.palpate.device.jni.NativeDevice;
import org.palpate.geometry.Vec3;

/**
 * Shows one device live in its own frame: position, buttons and sample rate; sends a gentle force
 * when the user presses Enter.
 *
 * <p>One thread, which reads and writes the device at 1 kHz.
 */
final class DeviceMonitor {
  private static final long FRAME_NANOS = TimeUnit.MILLISECONDS.toNanos(1);
  private static final long LINE_NANOS = TimeUnit.MILLISECONDS.toNanos(100);
  private static final long PUSH_NANOS = TimeUnit.MILLISECONDS.toNanos(300);

  /** Fraction of the device's maximum force, strong enough to feel and harmless. */
  private static final double PUSH_FRACTION = 0.1;

  private static final Vec3 NO_TORQUE = new Vec3();

  private final NativeDevice device;
  private final PrintWriter out;
  private final InputStream keys;
  private final DeviceState state = new DeviceState();
  private final Vec3 forceNewton = new Vec3();
  private long startNanos;
  private long shownNanos;
  private long shownSamples;
  private boolean pressed;
  private long pressedNanos;

  DeviceMonitor(NativeDevice device, InputStream keys, PrintWriter out) {
    this.device = device;
    this.keys = keys;
    this.out = out;
  }

  /**
   * Watches until the device disconnects or the time is over, then prints a summary of its samples.
   *
   * @return why the device disconnected; empty if the time was over
   */
  String watch(double seconds) throws IOException {
    String ending = watchUntilEnd(seconds);
    out.println(sampleSummary());
    out.flush();
    return ending;
  }

  private String watchUntilEnd(double seconds) throws IOException {
    String push =
        pushNewton() > 0
            ? format("Enter pushes %.2f N upwards for 0.3 s", pushNewton())
            : "no force feedback";
    out.println(device.specification().name() + ": " + push + ", Ctrl-C ends");
    startNanos = System.nanoTime();
    shownNanos = startNanos - LINE_NANOS;
    long nanos = startNanos;
    while ((nanos - startNanos) * 1e-9 < seconds) {
      if (!step(nanos)) {
        return device.ending();
      }
      if (nanos - shownNanos >= LINE_NANOS) {
        show(nanos);
      }
      LockSupport.parkNanos(nanos + FRAME_NANOS - System.nanoTime());
      nanos = System.nanoTime();
    }
    return "";
  }

  private boolean step(long nanos) {
    ReadStatus status = device.read(state);
    forceNewton.set(0, isPushing(nanos) ? pushNewton() : 0, 0);
    return status != ReadStatus.DISCONNECTED && device.write(forceNewton, NO_TORQUE);
  }

  private boolean isPushing(long nanos) {
    return pressed && nanos - pressedNanos < PUSH_NANOS;
  }

  private double pushNewton() {
    double maxNewton = device.specification().maxForceNewton();
    return Double.isFinite(maxNewton) ? PUSH_FRACTION * maxNewton : 0;
  }

  private void show(long nanos) throws IOException {
    while (keys.available() > 0 && keys.read() >= 0) {
      pressed = true;
      pressedNanos = nanos;
    }
    long samples = device.counters().samples();
    // The first read drains a backlog, which gives no rate.
    long fresh = nanos == startNanos ? 0 : samples - shownSamples;
    double samplesPerSecond = fresh * 1e9 / (nanos - shownNanos);
    shownSamples = samples;
    shownNanos = nanos;
    out.println(
        format(
            "%7.1f s  %8.2f %8.2f %8.2f mm  buttons %s  %.0f samples/s%s",
            (nanos - startNanos) * 1e-9,
            state.positionMm.x,
            state.positionMm.y,
            state.positionMm.z,
            Integer.toBinaryString(state.buttons),
            samplesPerSecond,
            condition(nanos)));
    out.flush();
  }

  /** Returns why there is no force, whether the monitor pushes, and the heat of the motors. */
  private String condition(long nanos) {
    String heat =
        device.motorHeat() > 0 ? format("  motors at %.0f %%", 100 * device.motorHeat()) : "";
    if (device.needsCalibration()) {
      return heat + "  calibrate it to enable the force";
    }
    if (device.isWaitingForHand()) {
      return heat + "  hold it still to enable the force";
    }
    return heat + (isPushing(nanos) ? "  pushing" : "");
  }

  /** Adds the counts of samples to a report. */
  void putInto(Report report) {
    counts().forEach(report::put);
  }

  private Map<String, Long> counts() {
    DeviceCounters counters = device.counters();
    Map<String, Long> counts = new LinkedHashMap<>();
    counts.put("samples", counters.samples());
    counts.put("merged", counters.merged());
    counts.put("late", counters.late());
    counts.put("lost", counters.lost());
    counts.put("duplicated", counters.duplicated());
    counts.put("out_of_order", counters.outOfOrder());
    counts.put("wrong_length", counters.wrongLength());
    counts.put("errors", counters.errors());
    return counts;
  }

  /** Returns one line: the number of samples, and of those that were faulty in some way. */
  private String sampleSummary() {
    StringJoiner line = new StringJoiner(", ");
    counts()
        .forEach(
            (what, count) -> {
              if (count > 0 || what.equals("samples")) {
                line.add(count + " " + what.replace('_', ' '));
              }
            });
    return line.toString();
  }

  private static String format(String pattern, Object... values) {
    return String.format(Locale.ROOT, pattern, values);
  }
}
