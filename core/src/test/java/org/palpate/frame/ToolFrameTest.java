package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.BrushEdit;
import org.palpate.edit.EditQueue;
import org.palpate.edit.SwapEdit;
import org.palpate.edit.VoxelEdit;
import org.palpate.force.ForceSettings;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;

class ToolFrameTest {
  private static final long MS = ManualClock.MS;
  private static final double INFINITE = Double.POSITIVE_INFINITY;

  private final CountingFloor bits = new CountingFloor();
  private final Body floor = new Body("floor", bits, Floor.GRID, Mobility.FIXED);
  private final BodyScene bodies = new BodyScene(List.of(floor));
  private final RigidTool plate = ToolSampler.ofShape(new BoxShape(8, 8, 2), 0.7);
  private final EditQueue edits = EditQueue.ofBodies(List.of(Floor.GRID));
  private final Quaternion turn = new Quaternion();
  private double deviceZ = 12;

  /** The floor, with a count of the words that were read. */
  private static final class CountingFloor extends BitCube {
    private long reads;

    CountingFloor() {
      super(Floor.EDGE, Floor.EDGE, Floor.EDGE);
      BitCube solid = Floor.bits();
      for (int n = 0; n < 512; n++) {
        setBrick(n % 8, n / 8 % 8, n / 64, solid.brick(n % 8, n / 8 % 8, n / 64));
      }
    }

    @Override
    public long brick(int brickX, int brickY, int brickZ) {
      reads++;
      return super.brick(brickX, brickY, brickZ);
    }
  }

  private long nowNanos = 1;

  @Test
  void aPressedPlatePushesTheHandUpAndTurnsItBackOntoTheFloor() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    run(frame, 5);
    assertEquals(0, device.lastForce().length());
    assertEquals(0, device.lastTorque().length());
    deviceZ = 7;
    turn.setRotationVector(new Vec3(0, 0.2, 0));
    run(frame, 300);
    assertTrue(frame.motion().contact());
    assertTrue(device.lastForce().z > 0.5, "force " + device.lastForce());
    assertTrue(device.lastTorque().y < -0.5, "torque " + device.lastTorque());
    FrameStatistics counts = frame.statistics();
    assertEquals(device.lastTorque().length(), counts.maxTorqueNewtonMm(), 20);
    assertTrue(counts.maxTorqueNewtonMm() >= device.lastTorque().length());
    assertEquals(0, counts.freed());
  }

  @Test
  void aSampleWithoutAnOrientationKeepsTheLastOneAndItsPositionCounts() {
    double[][] none = {
      {0, 0, 0, 0}, {Double.NaN, 0, 0, 0}, {1, Double.POSITIVE_INFINITY, 0, 0}, {3, 0, 0, 0},
    };
    for (double[] q : none) {
      ScriptedDevice device = device();
      ToolFrame frame = frame(device, unlimited());
      turn.setRotationVector(new Vec3(0.1, 0.2, 0.3));
      run(frame, 3);
      Quaternion good = new Quaternion().set(turn);
      turn.set(q[0], q[1], q[2], q[3]);
      deviceZ = 13;
      run(frame, 30);
      assertEquals(13, frame.motion().pose().translation.z);
      assertTrue(frame.motion().pose().rotation.sameBits(good), "" + turn);
      assertEquals(30, frame.statistics().faults().badOrientations());
      assertEquals(0, frame.statistics().faults().held());
      deviceZ = 12;
    }
  }

  @Test
  void aDeviceThatNeverHadAnOrientationLeavesTheToolAtTheIdentity() {
    ScriptedDevice device = device();
    turn.set(0, 0, 0, 0);
    ToolFrame frame = frame(device, unlimited());
    run(frame, 5);
    assertTrue(frame.motion().pose().rotation.sameBits(new Quaternion()));
  }

  @Test
  void aQuaternionAndItsNegativeAreTheSameToTheBit() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    deviceZ = 7;
    turn.setRotationVector(new Vec3(0.3, -0.2, 1));
    run(frame, 200);
    Pose rest = new Pose().set(frame.motion().pose());
    Vec3 force = device.lastForce();
    Vec3 torque = device.lastTorque();
    for (int n = 0; n < 10; n++) {
      turn.negate(turn);
      run(frame, 1);
      assertTrue(frame.motion().pose().sameBits(rest));
      assertTrue(device.lastForce().sameBits(force));
      assertTrue(device.lastTorque().sameBits(torque));
    }
  }

  @Test
  void startsFreeNearASolidWithTheOrientationKeptAndTheForceRamped() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    deviceZ = 4;
    turn.setRotationVector(new Vec3(0, 0, 0.5));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    assertTrue(frame.motion().pose().rotation.sameBits(turn));
    run(frame, 50);
    double half = device.lastForce().length();
    run(frame, 50);
    assertEquals(2 * half, device.lastForce().length(), 1e-6);
    assertTrue(half > 0.2);
    assertEquals(1, frame.statistics().freed());
  }

  @Test
  void forceAndTorqueStayWithinTheDevicesMaximaAndSlews() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, new FrameSettings(force(), 1, 0.125, 0, 20 * MS, 64, 3, 0.375));
    run(frame, 3);
    deviceZ = 2;
    turn.setRotationVector(new Vec3(0, 0.7, 0));
    Vec3 lastForce = new Vec3();
    Vec3 lastTorque = new Vec3();
    for (int n = 0; n < 80; n++) {
      run(frame, 1);
      assertTrue(device.lastForce().length() <= 1);
      assertTrue(device.lastTorque().length() <= 3);
      double force = device.lastForce().sub(lastForce, new Vec3()).length();
      double torque = device.lastTorque().sub(lastTorque, new Vec3()).length();
      assertTrue(force <= 0.125 * (1 + 1e-12), "n=" + n + " force changes by " + force);
      assertTrue(torque <= 0.375 * (1 + 1e-12), "n=" + n + " torque changes by " + torque);
      lastForce.set(device.lastForce());
      lastTorque.set(device.lastTorque());
    }
    assertEquals(1, lastForce.length(), 1e-12);
    assertEquals(3, lastTorque.length(), 1e-12);
  }

  /** Lets the hand press the tool against the floor and turn it. */
  private void pressAndTurn(ToolFrame frame) {
    run(frame, 3);
    deviceZ = 7;
    turn.setRotationVector(new Vec3(0, 0.2, 0));
    run(frame, 100);
  }

  @Test
  void aDeviceWithoutTorqueGetsTheForceAlone() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, new FrameSettings(force(), 10, INFINITE, 0, 20 * MS, 64));
    deviceZ = 7;
    turn.setRotationVector(new Vec3(0, 0.2, 0));
    run(frame, 100);
    assertTrue(device.lastForce().z > 0.5);
    assertTrue(device.torques.stream().allMatch(torque -> torque.length() == 0));
    assertEquals(0, frame.statistics().maxTorqueNewtonMm());
  }

  @Test
  void zeroForceAndZeroTorqueAreLastWhenTheDeviceGoes() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    pressAndTurn(frame);
    assertTrue(device.lastTorque().length() > 0);
    device.script = (read, state) -> ReadStatus.DISCONNECTED;
    assertEquals(FrameOutcome.DEVICE_GONE, frame.run(nowNanos));
    assertEquals(0, device.lastForce().length());
    assertEquals(0, device.lastTorque().length());
  }

  @Test
  void aSilenceDropsForceAndTorqueAndLeavesTheToolWhereItIs() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    pressAndTurn(frame);
    Pose rest = new Pose().set(frame.motion().pose());
    Vec3 torque = device.lastTorque();
    device.script = (read, state) -> ReadStatus.REPEATED;
    run(frame, 10);
    assertTrue(device.lastTorque().sameBits(torque), "held");
    run(frame, 15);
    assertEquals(0, device.lastForce().length());
    assertEquals(0, device.lastTorque().length());
    assertEquals(0, frame.motion().steps());
    assertTrue(frame.motion().pose().sameBits(rest));
  }

  @Test
  void solidsThatComeToTheToolSetItFreeWithARampedForce() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    run(frame, 3);
    assertFalse(frame.wasFreed());
    edits.offer(new BrushEdit(0, new Vec3(16, 16, 12), 5, true));
    int freed = 0;
    for (int n = 0; n < 30; n++) {
      run(frame, 1);
      freed += frame.wasFreed() ? 1 : 0;
      assertTrue(!frame.wasFreed() || device.lastForce().length() == 0);
    }
    assertTrue(freed > 0);
    assertEquals(freed, frame.statistics().freed());
    assertTrue(edits.isIdle());
    edits.offer(new VoxelEdit(0, 31, 31, 31, true));
    run(frame, 1);
    assertFalse(frame.wasFreed());
    assertThrows(
        IllegalArgumentException.class,
        () -> edits.offer(new SwapEdit(0, new BitCube(32, 32, 32))));
  }

  @Test
  void forceAndTorqueRiseFromZeroWithinTheirSlewsAfterSolidsSetTheToolFree() {
    ScriptedDevice device = device();
    FrameSettings slow =
        new FrameSettings(force(), INFINITE, 0.25, 100 * MS, 200 * MS, 1000, INFINITE, 1);
    ToolFrame frame = frame(device, slow);
    pressAndTurn(frame);
    assertTrue(device.lastForce().length() > 0.3, "held: " + device.lastForce());
    assertTrue(device.lastTorque().length() > 0.3, "held: " + device.lastTorque());
    edits.offer(new BrushEdit(0, new Vec3(16, 16, 10), 3, true));
    run(frame, 1);
    assertTrue(frame.wasFreed());
    assertEquals(0, device.lastForce().length());
    assertEquals(0, device.lastTorque().length());
    run(frame, 2);
    assertTrue(device.lastForce().length() < 0.2, "it rises from zero: " + device.lastForce());
    assertTrue(device.lastTorque().length() < 0.5, "it rises from zero: " + device.lastTorque());
  }

  @Test
  void theMostPointsThatKeptLessThanTheirClearanceAreThoseOfAnyFrame() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    deviceZ = 12.3; // the lower face of the plate lies at 11.3
    run(frame, 3);
    assertEquals(0, frame.mostReducedPoints());
    edits.offer(new VoxelEdit(0, 16, 16, 10, true));
    run(frame, 2);
    int most = frame.motion().reducedPoints();
    assertTrue(most > 0);
    assertEquals(most, frame.mostReducedPoints());
  }

  @Test
  void skipsOfAnEarlierFrameWithTheSameSolverDoNotCount() {
    ScriptedDevice device = device();
    RigidSolver solver =
        new RigidSolver(bodies, plate, RigidSettings.ofWholeBodies(8, bodies, plate));
    ToolFrame first = frame(device, solver);
    pressAndTurn(first);
    assertTrue(skips(first) > 0);
    assertEquals(0, skips(frame(device, solver)));
  }

  private static long skips(ToolFrame frame) {
    return frame.statistics().skipped().values().stream().mapToLong(Long::longValue).sum();
  }

  private ToolFrame frame(ScriptedDevice device, RigidSolver solver) {
    return new ToolFrame(
        device,
        bodies,
        solver,
        RigidCoupling.of(plate, 0.5),
        unlimited(),
        edits,
        ToolFramePublisher.NONE);
  }

  /** Otherwise that frame would grow the whole floor anew and be late. */
  @Test
  void theFirstFrameAfterASilenceWithManyEditsReadsFewVoxels() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    long ofTheFirst = reads(frame); // It looks for contacts, as the one after the silence does.
    run(frame, 2);
    edits.offer(new VoxelEdit(0, 16, 16, 31, true));
    long ofAnEdit = reads(frame);
    device.script = (read, state) -> ReadStatus.REPEATED;
    for (int n = 0; n < 200; n++) {
      edits.offer(new VoxelEdit(0, n % 32, n / 32, 31, true));
      run(frame, 1);
    }
    assertTrue(edits.isIdle());
    device.script = this::read;
    long ofResuming = reads(frame);
    assertTrue(
        ofResuming <= ofTheFirst + ofAnEdit,
        ofResuming + " words, the first " + ofTheFirst + ", with one edit " + ofAnEdit);
  }

  private long reads(ToolFrame frame) {
    long before = bits.reads;
    run(frame, 1);
    return bits.reads - before;
  }

  @Test
  void anotherStiffnessCountsFromTheNextFrameOn() {
    ScriptedDevice device = device();
    ToolFrame frame = frame(device, unlimited());
    run(frame, 3);
    deviceZ = 7;
    run(frame, 200);
    Vec3 before = device.lastForce();
    frame.requestForce(ForceSettings.of(1, 0));
    run(frame, 1);
    assertEquals(2 * before.z, device.lastForce().z, 1e-9);
  }

  @Test
  void publishesPosesForceAndTorqueOfTheSameFrame() {
    ScriptedDevice device = device();
    Pose published = new Pose();
    Vec3 torque = new Vec3();
    ToolFrame frame =
        frame(
            device,
            unlimited(),
            (d, motion, f, t, n) -> {
              published.set(motion.pose());
              torque.set(t);
              assertTrue(f.sameBits(device.lastForce()));
            });
    deviceZ = 7;
    turn.setRotationVector(new Vec3(0, 0.2, 0));
    run(frame, 50);
    assertTrue(published.sameBits(frame.motion().pose()));
    assertTrue(torque.sameBits(device.lastTorque()));
  }

  private ScriptedDevice device() {
    return new ScriptedDevice(this::read);
  }

  private ReadStatus read(int read, DeviceState state) {
    state.orientation.set(turn);
    return fresh(state, read, 16, 16, deviceZ);
  }

  private static ForceSettings force() {
    return ForceSettings.of(0.5, 0);
  }

  private static FrameSettings unlimited() {
    return new FrameSettings(
        force(), INFINITE, INFINITE, 100 * MS, 20 * MS, 64, INFINITE, INFINITE);
  }

  private ToolFrame frame(ScriptedDevice device, FrameSettings settings) {
    return frame(device, settings, ToolFramePublisher.NONE);
  }

  private ToolFrame frame(
      ScriptedDevice device, FrameSettings settings, ToolFramePublisher publisher) {
    return new ToolFrame(
        device,
        bodies,
        new RigidSolver(bodies, plate, RigidSettings.ofWholeBodies(8, bodies, plate)),
        RigidCoupling.of(plate, 0.5),
        settings,
        edits,
        publisher);
  }

  private void run(ToolFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      frame.run(nowNanos);
      nowNanos += MS;
    }
  }
}
