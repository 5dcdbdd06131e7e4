package org.palpate.device;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

class WorkspaceDeviceTest {
  private static final long SEED = seed();
  private static final DeviceSpecification OMNI =
      new DeviceSpecification("omni", "7", 3.3, 0.7, 80, 1_000_000, true, 188);

  private final Random random = new Random(SEED);

  private static long seed() {
    String given = System.getProperty("palpate.seed");
    boolean isNumber = given != null && given.matches("-?\\d+");
    return isNumber ? Long.parseLong(given) : 20130207L;
  }

  /** A device whose state a test sets. */
  private static final class SettableDevice implements HapticDevice {
    final DeviceState next = new DeviceState();
    final Vec3 feltNewton = new Vec3();
    final Vec3 feltNewtonMm = new Vec3();

    @Override
    public DeviceSpecification specification() {
      return OMNI;
    }

    @Override
    public ReadStatus read(DeviceState state) {
      next.timeNanos += 1_000_000;
      state.set(next);
      return ReadStatus.FRESH;
    }

    @Override
    public boolean write(Vec3 forceNewton, Vec3 torqueNewtonMm) {
      feltNewton.set(forceNewton);
      feltNewtonMm.set(torqueNewtonMm);
      return true;
    }

    @Override
    public void close() {}
  }

  private Vec3 randomVec(double size) {
    return new Vec3(
        size * random.nextGaussian(), size * random.nextGaussian(), size * random.nextGaussian());
  }

  /** Returns a right-handed rotation by Gram-Schmidt on random vectors. */
  private RigidTransform randomRotation(Vec3 origin) {
    Vec3 x = randomVec(1);
    x.mul(1 / x.length(), x);
    Vec3 y = randomVec(1);
    y.sub(x.mul(x.dot(y), new Vec3()), y);
    y.mul(1 / y.length(), y);
    Vec3 z = new Vec3(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
    return new RigidTransform(x, y, z, origin);
  }

  private Workspace randomWorkspace() {
    Vec3 scale =
        new Vec3(Math.exp(random.nextGaussian()), Math.exp(random.nextGaussian()), Math.exp(1));
    return new Workspace(randomRotation(randomVec(50)), scale);
  }

  @Test
  void noScaleOrRotationMakesASpringStifferOrGivesItEnergy() {
    for (int i = 0; i < 300; i++) {
      Workspace workspace = randomWorkspace();
      double stiffness = workspace.stiffnessNewtonPerMm(OMNI, 0.5);
      Vec3 a = randomVec(1);
      Vec3 b = randomVec(1);
      Vec3 forceA = springForce(workspace, stiffness, a);
      Vec3 forceB = springForce(workspace, stiffness, b);
      String where = "seed=" + SEED + " i=" + i;
      double limit = 0.5 * 0.7 * a.dot(a);
      assertTrue(-forceA.dot(a) <= limit * (1 + 1e-12) && -forceA.dot(a) >= 0, where);
      assertEquals(forceA.dot(b), forceB.dot(a), 1e-9, where + ": the force field has no curl");
    }
  }

  /** Returns the force on a hand, moved by {@code handMm}, of a spring to the world's origin. */
  private static Vec3 springForce(Workspace workspace, double stiffness, Vec3 handMm) {
    Vec3 movedMm = workspace.toWorld(handMm, new Vec3());
    movedMm.sub(workspace.deviceToWorld().origin(), movedMm);
    return workspace.toDeviceForce(movedMm.mul(-stiffness, new Vec3()), new Vec3());
  }

  @Test
  void fitsABoxIntoTheWorkspaceAlongEveryAxis() {
    Vec3 low = new Vec3(-10, 20, 300);
    Vec3 high = new Vec3(190, 60, 340);
    Workspace whole = Workspace.fit(OMNI, RigidTransform.identity(), low, high);
    Workspace each = Workspace.fitEachAxis(OMNI, RigidTransform.identity(), low, high);
    assertTrue(new Vec3(90, 40, 320).sameBits(whole.toWorld(new Vec3(), new Vec3())));
    assertEquals(190, whole.toWorld(new Vec3(80, 0, 0), new Vec3()).x, 1e-9);
    assertEquals(whole.scale().x, whole.scale().y);
    assertEquals(60, each.toWorld(new Vec3(0, 80, 0), new Vec3()).y, 1e-9);
    assertEquals(0.5 * 0.7 / 1.25, whole.stiffnessNewtonPerMm(OMNI, 0.5), 1e-12);
  }

  @Test
  void rotatesTheOrientationWithTheFrame() {
    for (int i = 0; i < 300; i++) {
      RigidTransform frame = randomRotation(new Vec3());
      SettableDevice hand = new SettableDevice();
      Vec3 axis = randomVec(1);
      axis.mul(1 / axis.length(), axis);
      double half = random.nextDouble() * 3;
      hand.next.orientation.x = axis.x * Math.sin(half);
      hand.next.orientation.y = axis.y * Math.sin(half);
      hand.next.orientation.z = axis.z * Math.sin(half);
      hand.next.orientation.w = Math.cos(half);
      DeviceState seen = readOnce(hand, new Workspace(frame, new Vec3(1, 1, 1)));
      Vec3 arrow = randomVec(1);
      Vec3 expected = frame.rotate(rotated(hand.next, arrow), new Vec3());
      Vec3 difference = rotated(seen, arrow).sub(expected, new Vec3());
      assertTrue(difference.length() < 1e-9, "seed=" + SEED + " i=" + i + " " + difference);
    }
  }

  private static DeviceState readOnce(HapticDevice device, Workspace workspace) {
    DeviceState state = new DeviceState();
    new WorkspaceDevice(device, workspace, WorkspaceDevice.Controls.standard()).read(state);
    return state;
  }

  /** Rotates a vector by the quaternion of a state, by v + 2 u x (u x v + w v). */
  private static Vec3 rotated(DeviceState q, Vec3 v) {
    double ax = q.orientation.y * v.z - q.orientation.z * v.y + q.orientation.w * v.x;
    double ay = q.orientation.z * v.x - q.orientation.x * v.z + q.orientation.w * v.y;
    double az = q.orientation.x * v.y - q.orientation.y * v.x + q.orientation.w * v.z;
    return new Vec3(
        v.x + 2 * (q.orientation.y * az - q.orientation.z * ay),
        v.y + 2 * (q.orientation.z * ax - q.orientation.x * az),
        v.z + 2 * (q.orientation.x * ay - q.orientation.y * ax));
  }

  @Test
  void neitherClutchNorSpeedMakesThePointJump() {
    SettableDevice hand = new SettableDevice();
    Workspace workspace = randomWorkspace();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, workspace, WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    Vec3 lastMm = new Vec3().set(state.positionMm);
    double mostMm = 0.1 * Math.sqrt(3) * workspace.largestScale() * (1 + 1e-9);
    for (int i = 0; i < 5000; i++) {
      hand.next.buttons = random.nextInt(20) == 0 ? random.nextInt(8) : hand.next.buttons;
      Vec3 step = new Vec3(random.nextDouble(), random.nextDouble(), random.nextDouble());
      hand.next.positionMm.add(step.mul(0.1, step), hand.next.positionMm);
      device.read(state);
      double movedMm = state.positionMm.sub(lastMm, new Vec3()).length();
      assertTrue(movedMm <= mostMm + 1e-9, "seed=" + SEED + " i=" + i + " movedMm=" + movedMm);
      assertTrue(!device.isClutched() || movedMm < 1e-12, "seed=" + SEED + " i=" + i);
      lastMm.set(state.positionMm);
    }
  }

  @Test
  void aProgramCanHoldTheClutch() {
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    Vec3 before = new Vec3().set(state.positionMm);
    device.holdClutch(true);
    hand.next.positionMm.set(9, 8, 7);
    device.read(state);
    assertTrue(device.isClutched() && device.isClutchRequested());
    assertTrue(before.sameBits(state.positionMm));
    device.holdClutch(false);
    device.read(state);
    assertFalse(device.isClutched());
  }

  @Test
  void theClutchDropsTheForceAtOnceAndReturnsItGradually() {
    SettableDevice hand = new SettableDevice();
    Workspace same = new Workspace(RigidTransform.identity(), new Vec3(1, 1, 1));
    WorkspaceDevice device = new WorkspaceDevice(hand, same, new WorkspaceDevice.Controls(1, 0, 1));
    DeviceState state = new DeviceState();
    device.read(state);
    assertEquals(2, felt(device, hand, state));
    hand.next.buttons = 1;
    assertEquals(0, felt(device, hand, state));
    hand.next.buttons = 0;
    double last = felt(device, hand, state);
    assertEquals(0, last);
    for (int i = 0; i < 150; i++) {
      double now = felt(device, hand, state);
      assertTrue(now > last && now - last <= 2.0 / 150 + 1e-9, "i=" + i + " now=" + now);
      last = now;
    }
    assertEquals(2, last);
  }

  private static double felt(WorkspaceDevice device, SettableDevice hand, DeviceState state) {
    device.read(state);
    device.write(new Vec3(2, 0, 0), new Vec3());
    return hand.feltNewton.x;
  }

  @Test
  void theClutchHoldsTheOrientationAndItsReleaseTurnsNothing() {
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    hand.next.orientation.setRotationVector(randomVec(1));
    device.read(state);
    Quaternion held = new Quaternion().set(state.orientation);
    device.holdClutch(true);
    hand.next.orientation.setRotationVector(randomVec(1));
    device.read(state);
    assertTrue(held.sameBits(state.orientation));
    device.holdClutch(false);
    device.read(state);
    assertEquals(1, Math.abs(held.dot(state.orientation)), 1e-12);
    device.read(state);
    assertEquals(1, Math.abs(held.dot(state.orientation)), 1e-12);
    Quaternion before = new Quaternion().set(hand.next.orientation);
    hand.next.orientation.setRotationVector(randomVec(1));
    device.read(state);
    double turned = before.conjugate(before).multiply(hand.next.orientation, before).angle();
    double seen = held.conjugate(held).multiply(state.orientation, held).angle();
    assertEquals(turned, seen, 1e-9);
  }

  @Test
  void afterAReleaseTheToolTurnsAboutTheAxesOfTheHand() {
    SettableDevice hand = new SettableDevice();
    RigidTransform frame = randomRotation(new Vec3());
    WorkspaceDevice device =
        new WorkspaceDevice(
            hand, new Workspace(frame, new Vec3(1, 1, 1)), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    device.holdClutch(true);
    hand.next.orientation.setRotationVector(randomVec(1));
    device.read(state);
    device.holdClutch(false);
    device.read(state);
    assertTurnsAboutHandsAxes(device, hand, state, frame);
  }

  /** Turns the hand, and expects that the tool turns by the same rotation vector in the world. */
  private void assertTurnsAboutHandsAxes(
      WorkspaceDevice device, SettableDevice hand, DeviceState state, RigidTransform frame) {
    Vec3 turn = randomVec(0.3);
    Quaternion before = new Quaternion().set(state.orientation);
    Quaternion step = new Quaternion();
    step.setRotationVector(turn);
    step.multiply(hand.next.orientation, hand.next.orientation);
    device.read(state);
    Quaternion expected = new Quaternion();
    expected.setRotationVector(frame.rotate(turn, new Vec3()));
    expected.multiply(before, expected);
    assertEquals(1, Math.abs(expected.dot(state.orientation)), 1e-12);
  }

  @Test
  void otherAxesMoveNothingAndLaterMotionAndForceFollowThem() {
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    hand.next.positionMm.set(randomVec(20));
    hand.next.orientation.setRotationVector(randomVec(1));
    device.read(state);
    for (int i = 0; i < 50; i++) {
      Vec3 position = new Vec3().set(state.positionMm);
      Quaternion orientation = new Quaternion().set(state.orientation);
      RigidTransform frame = randomRotation(new Vec3());
      device.turnAxes(frame);
      device.read(state);
      String where = "seed=" + SEED + " i=" + i;
      assertTrue(position.sub(state.positionMm, new Vec3()).length() < 1e-9, where);
      assertEquals(1, Math.abs(orientation.dot(state.orientation)), 1e-12, where);
      Vec3 step = randomVec(1);
      hand.next.positionMm.add(step, hand.next.positionMm);
      position.set(state.positionMm);
      device.read(state);
      Vec3 moved = state.positionMm.sub(position, new Vec3());
      device.write(moved, new Vec3());
      assertTrue(
          hand.feltNewton.dot(step) >= 0, where + ": a force along a motion acts along the hand's");
      assertTurnsAboutHandsAxes(device, hand, state, frame);
    }
  }

  @Test
  void theHandsRightIsTheRightOfTheNewAxes() {
    SettableDevice hand = new SettableDevice();
    Workspace same = new Workspace(RigidTransform.identity(), new Vec3(2, 2, 2));
    WorkspaceDevice device = new WorkspaceDevice(hand, same, WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    hand.next.positionMm.set(5, 0, 0);
    device.read(state);
    Vec3 left = new Vec3(0, 1, 0);
    device.turnAxes(new RigidTransform(left, new Vec3(0, 0, 1), new Vec3(1, 0, 0), new Vec3()));
    device.read(state);
    hand.next.positionMm.set(6, 0, 0);
    device.read(state);
    assertEquals(10, state.positionMm.x, 1e-12);
    assertEquals(2, state.positionMm.y, 1e-12);
    device.write(new Vec3(0, 3, 0), new Vec3());
    assertEquals(3, hand.feltNewton.x, 1e-12);
  }

  @Test
  void theTorqueIsTurnedLikeTheFrameAndDividedByTheScale() {
    SettableDevice hand = new SettableDevice();
    Workspace workspace = randomWorkspace();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, workspace, WorkspaceDevice.Controls.standard());
    device.read(new DeviceState());
    Vec3 torque = randomVec(50);
    device.write(new Vec3(), torque);
    Vec3 back = workspace.deviceToWorld().rotate(hand.feltNewtonMm, new Vec3());
    back.mul(workspace.largestScale(), back);
    assertTrue(back.sub(torque, new Vec3()).length() < 1e-9, back + " " + torque);
    assertEquals(
        OMNI.maxTorqueNewtonMm() * workspace.largestScale(),
        device.specification().maxTorqueNewtonMm());
  }

  @Test
  void aPositionThatIsNotFinitePassesAndChangesNothing() {
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    Vec3 beforeMm = new Vec3().set(state.positionMm);
    hand.next.positionMm.x = Double.NaN;
    hand.next.buttons = 6;
    device.read(state);
    assertFalse(state.positionMm.isFinite());
    hand.next.positionMm.x = 0;
    hand.next.buttons = 0;
    device.read(state);
    assertTrue(beforeMm.sameBits(state.positionMm), beforeMm + " " + state.positionMm);
  }

  @Test
  void otherAxesWaitForAPositionThatTheyMapToFiniteNumbers() {
    SettableDevice hand = new SettableDevice();
    Workspace enlarging = new Workspace(randomRotation(randomVec(50)), new Vec3(10, 10, 10));
    WorkspaceDevice device =
        new WorkspaceDevice(hand, enlarging, WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    Vec3 beforeMm = new Vec3().set(state.positionMm);
    device.turnAxes(RigidTransform.identity());
    hand.next.positionMm.x = Double.MAX_VALUE;
    device.read(state);
    assertFalse(state.positionMm.isFinite());
    hand.next.positionMm.x = 0;
    device.read(state);
    assertTrue(beforeMm.sameBits(state.positionMm), beforeMm + " " + state.positionMm);
  }

  @Test
  void anOrientationThatIsNoRotationPassesAndChangesNothing() {
    Quaternion[] wrong = {
      new Quaternion(0, 0, 0, 0),
      new Quaternion(Double.NaN, 0, 0, 0),
      new Quaternion(1e200, 0, 0, 0),
      new Quaternion(0, Double.POSITIVE_INFINITY, 0, 0)
    };
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    device.read(state);
    Quaternion before = new Quaternion().set(state.orientation);
    for (Quaternion orientation : wrong) {
      device.turnAxes(randomRotation(new Vec3()));
      hand.next.orientation.set(orientation);
      device.read(state);
      assertFalse(state.orientation.isNearUnit(), orientation + " passes");
      hand.next.orientation.setRotationVector(randomVec(1));
      device.read(state);
      assertEquals(1, Math.abs(before.dot(state.orientation)), 1e-12, "after " + orientation);
    }
  }

  @Test
  void anErrorOfTheNormDoesNotGrowWhenAxesTurn() {
    SettableDevice hand = new SettableDevice();
    WorkspaceDevice device =
        new WorkspaceDevice(hand, randomWorkspace(), WorkspaceDevice.Controls.standard());
    DeviceState state = new DeviceState();
    hand.next.orientation.w = 1 + 1e-6;
    for (int i = 0; i < 2000; i++) {
      device.turnAxes(randomRotation(new Vec3()));
      device.read(state);
    }
    assertEquals(hand.next.orientation.w, state.orientation.norm(), 1e-12);
  }

  @Test
  void refusesAMirrorAndAScaleOfZero() {
    RigidTransform mirror =
        new RigidTransform(new Vec3(-1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1), new Vec3());
    assertThrows(IllegalArgumentException.class, () -> new Workspace(mirror, new Vec3(1, 1, 1)));
    assertThrows(
        IllegalArgumentException.class,
        () -> new Workspace(RigidTransform.identity(), new Vec3(1, 0, 1)));
  }
}
