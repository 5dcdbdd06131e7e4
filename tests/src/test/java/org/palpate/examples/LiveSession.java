package org.palpate.examples;

import org.palpate.device.HapticDevice;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.SolverKind;
import org.palpate.host.TouchSession;
import org.palpate.loop.LoopReport;
import org.palpate.sync.TouchProperty;
import org.palpate.volume.phantom.Phantom;

/** Runs a live session: a simulated hand touches a phantom at 1 kHz for two seconds. */
public final class LiveSession {
  private static final long SAMPLE_NANOS = 1_000_000;
  private static final long FRAMES = 2000;
  private static final long TICK_MILLIS = 33;

  /** Takes no arguments. */
  public static void main(String[] args) throws InterruptedException {
    ContactSettings settings =
        ContactSettings.builder(SolverKind.SMOOTH).stiffness(0.5).friction(0.3).build();
    ContactScene scene = new ContactScene(Phantom.parse("sphere:64").segments(), settings);
    HapticDevice device = new SimulatedDevice(7, scene.handTarget(), SAMPLE_NANOS);

    // Closing the session sends zero force last, and closes the device.
    try (TouchSession session =
        new TouchSession(
            scene,
            device,
            SessionSettings.standard()
                .withListener(end -> System.out.println("ended: " + end.cause())))) {
      session.start();
      Vec3 pointMm = new Vec3();
      Vec3 force = new Vec3();
      while (!session.supervise() && session.status().frames() < FRAMES) {
        session.takeUpdates();
        TouchProperty touch = session.properties().touch();
        scene.grid().gridToWorld(touch.interactionPoint(pointMm), pointMm);
        System.out.println(pointMm + " mm: " + touch.force(force).length() + " N");
        Thread.sleep(TICK_MILLIS);
      }

      session.stop();
      LoopReport report = session.report();
      System.out.println(report.frames() + " frames, " + report.lateFrames() + " of them late");
      System.out.println("contact in " + report.statistics().contactFrames() + " frames");
    }
  }
}
