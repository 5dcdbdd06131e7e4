package org.palpate.examples;

import org.palpate.device.HandTarget;
import org.palpate.edit.BrushEdit;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.MouseDevice;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.volume.phantom.Phantom;

/** Presses on a sphere, removes the voxels under the device, and feels that the force is gone. */
public final class EditWhileTouching {
  private static final int SPHERE = 0; // The index of the segment.

  /** Takes no arguments. */
  public static void main(String[] args) throws InterruptedException {
    ContactScene scene =
        new ContactScene(Phantom.parse("sphere:64").segments(), ContactSettings.standard());
    HandTarget box = scene.handTarget();
    MouseDevice device = new MouseDevice(box, 1_000_000); // Any thread may move it.
    try (TouchSession session = new TouchSession(scene, device, SessionSettings.standard())) {
      session.start();

      Vec3 insideMm = new Vec3(box.highMm().x - 3, 32, 32);
      device.moveTo(insideMm);
      awaitSteadyForce(session);
      System.out.println("pressed 3 mm deep: " + session.status().forceNewton() + " N");

      // The haptic thread alone changes voxels; it applies queued edits between two frames.
      Vec3 centre = scene.grid().worldToGrid(insideMm, new Vec3());
      scene.edits().offer(new BrushEdit(SPHERE, centre, 6, false));
      runFrames(session, 100);
      System.out.println("voxels removed: " + session.status().forceNewton() + " N");

      // A solid that grows over the interaction point sets it free at the nearest free voxel.
      scene.edits().offer(new BrushEdit(SPHERE, centre, 4, true));
      awaitSteadyForce(session);
      System.out.println("filled again: " + session.status().forceNewton() + " N");

      session.stop();
      System.out.println("set free: " + session.report().statistics().freed() + " time");
    }
  }

  /** Waits for the hand to arrive, and for the ramp of the force, which a late frame restarts. */
  private static void awaitSteadyForce(TouchSession session) throws InterruptedException {
    runFrames(session, 1000);
    double before;
    do {
      before = session.status().forceNewton();
      runFrames(session, 100);
    } while (session.status().forceNewton() != before);
  }

  private static void runFrames(TouchSession session, long frames) throws InterruptedException {
    long end = session.status().frames() + frames;
    while (!session.supervise() && session.status().frames() < end) {
      session.takeUpdates();
      Thread.sleep(33);
    }
  }
}
