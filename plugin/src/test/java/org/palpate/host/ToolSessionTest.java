package org.palpate.host;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.palpate.body.BodyScene;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceState;
import org.palpate.device.HapticDevice;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.LoopEnd;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.volume.phantom.Phantom;

class ToolSessionTest {
  private static final long PERIOD_NANOS = 1_000_000;

  private final ContactScene contact =
      new ContactScene(Phantom.parse("sphere:48").segments(), ContactSettings.standard());
  private final BodyScene bodies = contact.newBodies();
  private final RigidTool tool = ToolSampler.ofShape(RodShape.capsule(2, 8), 0.7);
  private final ToolScene scene =
      new ToolScene(contact, bodies, tool, List.of(Clearance.POINTS), OptionalDouble.of(40));

  /** A simulated hand that keeps the last force and torque, and may go away. */
  private static final class WatchedHand extends DeviceDecorator {
    private final Vec3 lastForce = new Vec3();
    private final Vec3 lastTorque = new Vec3();
    private volatile double mostTorque;
    private volatile int writes;
    private volatile boolean gone;

    WatchedHand(HapticDevice hand) {
      super(hand);
    }

    @Override
    public ReadStatus read(DeviceState state) {
      return gone ? ReadStatus.DISCONNECTED : device.read(state);
    }

    @Override
    @SuppressWarnings("NonAtomicVolatileUpdate") // one writer, the haptic thread
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      lastForce.set(forceNewton);
      lastTorque.set(torqueNewtonMm);
      mostTorque = Math.max(mostTorque, torqueNewtonMm.length());
      writes++;
      return device.write(forceNewton, torqueNewtonMm);
    }
  }

  private WatchedHand hand() {
    return new WatchedHand(SimulatedDevice.withOrientation(2, scene.handTarget(), PERIOD_NANOS));
  }

  private TouchSession session(WatchedHand hand) {
    return new TouchSession(scene, hand, SessionSettings.standard());
  }

  /** Runs until the hand has felt a torque, but for a minute at most. */
  private static void touch(TouchSession session, WatchedHand hand) throws InterruptedException {
    session.start();
    for (int tick = 0; tick < 6000 && hand.mostTorque < 1 && !session.supervise(); tick++) {
      TimeUnit.MILLISECONDS.sleep(10);
      session.takeUpdates();
    }
    assertTrue(hand.mostTorque >= 1, "torque " + hand.mostTorque + " of " + hand.writes);
  }

  @Test
  void zeroForceAndZeroTorqueAreLastWhenTheSessionIsStopped() throws InterruptedException {
    WatchedHand hand = hand();
    try (TouchSession session = session(hand)) {
      touch(session, hand);
      assertEquals(LoopEnd.Cause.STOPPED, session.stop().cause());
    }
    assertEquals(0, hand.lastForce.length());
    assertEquals(0, hand.lastTorque.length());
    assertTrue(hand.mostTorque <= SimulatedDevice.MAX_TORQUE_NEWTON_MM);
  }

  @Test
  void zeroForceAndZeroTorqueAreLastWhenTheDeviceGoes() throws InterruptedException {
    WatchedHand hand = hand();
    try (TouchSession session = session(hand)) {
      touch(session, hand);
      hand.gone = true;
      while (!session.supervise()) {
        TimeUnit.MILLISECONDS.sleep(5);
      }
      assertEquals(LoopEnd.Cause.DEVICE_GONE, session.stop().cause());
    }
    assertEquals(0, hand.lastForce.length());
    assertEquals(0, hand.lastTorque.length());
  }

  @Test
  void publishesThePoseAndTheTorqueBesideTheReferencePoint() throws InterruptedException {
    WatchedHand hand = hand();
    try (TouchSession session = session(hand)) {
      touch(session, hand);
      session.stop();
      session.takeUpdates();
      ToolScene.Held held = session.held().orElseThrow();
      RigidTransform pose = held.publisher().toolToWorld().read();
      assertTrue(pose.isOrthonormal());
      Vec3 point = session.properties().touch().interactionPoint(new Vec3());
      contact.grid().gridToWorld(point, point);
      assertEquals(0, point.sub(pose.origin(), new Vec3()).length(), 1e-9);
      assertEquals(tool.count(), held.scene().tool().count());
    }
  }

  @Test
  void theStiffnessOfBothKindsIsTunedTogetherAndFrictionIsTuned() {
    TouchSession session = session(hand());
    ContactTuning tuning = session.tuning();
    assertEquals(Optional.empty(), tuning.solver());
    assertEquals(Optional.empty(), tuning.solverHelp());
    assertEquals("rigid tool   0.50 N/mm   friction 0.20", tuning.line());
    tuning.increaseStiffness();
    tuning.increaseFriction();
    tuning.nextSolver();
    assertEquals("rigid tool   0.63 N/mm   friction 0.25", tuning.line());
    session.close();
  }

  @Test
  void theSimulatedHandPressesAboveTheSurfaceByTheReachOfTheTool() {
    List<Vec3> plain = contact.handTarget().surfaceMm();
    List<Vec3> raised = scene.handTarget().surfaceMm();
    Vec3 middle = new Vec3(24, 24, 24);
    double byMm =
        raised.get(7).sub(middle, new Vec3()).length()
            - plain.get(7).sub(middle, new Vec3()).length();
    assertEquals(2, byMm, 0.2, "the radius of the capsule");
  }
}
