package org.palpate.examples;

import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.volume.phantom.Phantom;

/** A device of your own: a probe that sinks 0.01 mm in each sample, and keeps its last force. */
public final class CustomDevice implements HapticDevice {
  private static final double STEP_MM = 0.01;
  private static final long SAMPLE_NANOS = 1_000_000;

  private final Vec3 startMm;
  private long samples; // The haptic thread alone reads and writes it.
  private volatile double lastNewton;
  private volatile boolean closed;

  private CustomDevice(Vec3 startMm) {
    this.startMm = startMm;
  }

  @Override
  public DeviceSpecification specification() {
    double maxForceNewton = 10;
    double maxStiffnessNewtonPerMm = 1;
    double workspaceRadiusMm = 50;
    return new DeviceSpecification(
        "probe", "", maxForceNewton, maxStiffnessNewtonPerMm, workspaceRadiusMm, 0);
  }

  @Override
  public ReadStatus read(DeviceState state) {
    if (closed) {
      return ReadStatus.DISCONNECTED;
    }
    state.positionMm.set(startMm.x, startMm.y, startMm.z - samples * STEP_MM);
    state.timeNanos = samples++ * SAMPLE_NANOS;
    return ReadStatus.FRESH;
  }

  @Override
  public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
    lastNewton = forceNewton.length(); // A real device would send it to its motors.
    return !closed;
  }

  @Override
  public void close() {
    lastNewton = 0;
    closed = true;
  }

  /** Lowers the probe onto a sphere for two seconds. */
  public static void main(String[] args) throws InterruptedException {
    ContactScene scene =
        new ContactScene(Phantom.parse("sphere:64").segments(), ContactSettings.standard());
    CustomDevice probe = new CustomDevice(new Vec3(32, 32, 64));
    try (TouchSession session = new TouchSession(scene, probe, SessionSettings.standard())) {
      session.start();
      while (!session.supervise() && session.status().frames() < 2000) {
        session.takeUpdates();
        System.out.println(session.status().frames() + " frames: " + probe.lastNewton + " N");
        Thread.sleep(33);
      }
    }
    System.out.println("at the end: " + probe.lastNewton + " N");
  }
}
