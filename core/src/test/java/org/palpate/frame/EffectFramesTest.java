package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.palpate.testing.ScriptedDevice.fresh;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.carve.CarveSettings;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.force.EffectPlan;
import org.palpate.force.EffectSite;
import org.palpate.force.ForceSettings;
import org.palpate.force.GreyMaterials;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.force.guide.GuideStrength;
import org.palpate.force.guide.Guides;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.loop.ManualClock;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.ScalarVolume;

/** Effects in whole frames of a point and of a rigid tool. */
class EffectFramesTest {
  private static final long MS = ManualClock.MS;
  private static final double INFINITE = Double.POSITIVE_INFINITY;
  private static final double STIFFNESS = 0.25;
  private static final GuideStrength STRENGTH =
      new GuideStrength(OptionalDouble.of(STIFFNESS), OptionalDouble.of(100), INFINITE);

  private final Floor floor = Floor.make();
  private final Vec3 hand = new Vec3(16, 16, 12);
  private final Quaternion turn = new Quaternion();
  private final ScriptedDevice device = new ScriptedDevice(this::read);
  private long nowNanos = 1;

  private ReadStatus read(int read, DeviceState state) {
    state.orientation.set(turn);
    return fresh(state, read, hand.x, hand.y, hand.z);
  }

  private void run(HapticFrame frame, int frames) {
    for (int n = 0; n < frames; n++) {
      frame.run(nowNanos);
      nowNanos += MS;
    }
  }

  private static List<HapticEffect> made(EffectPlan plan) {
    return List.of(
        plan.make(
            new EffectSite(RigidTransform.identity(), 0.5, 2, INFINITE, List.of(new Vec3()))));
  }

  private static EffectPlan axis() {
    return Guides.axis(new Vec3(10, 16, 0), new Vec3(0, 0, 1), STRENGTH);
  }

  @Test
  void aGuideInEmptySpacePullsThePointWithinItsRamp() {
    PointFrame frame = floor.frame(device);
    run(frame, 50);
    frame.requestEffects(made(axis()));
    double last = 0;
    for (int n = 0; n < 300; n++) {
      run(frame, 1);
      double now = device.lastForce().x;
      assertTrue(Math.abs(now - last) <= 6 * STIFFNESS / 200 + 1e-12, "a step in frame " + n);
      last = now;
    }
    assertEquals("(-1.5, 0.0, 0.0)", device.lastForce().toString());
    assertEquals(0, device.lastTorque().length());
    frame.requestEffects(List.of());
    run(frame, 300);
    assertEquals(0, device.lastForce().length());
  }

  /** A point has no orientation that a hand could hold it by. */
  @Test
  void aPointGetsNoTorqueFromAnEffectThatTurns() {
    FrameSettings turning =
        new FrameSettings(
            ForceSettings.of(0.5, 0), INFINITE, INFINITE, 0, 20 * MS, 64, INFINITE, INFINITE);
    PointFrame frame = floor.frame(device, turning);
    frame.requestEffects(
        List.of(
            (hand, forceNewton, torqueNewtonMm) -> {
              forceNewton.x += 1;
              torqueNewtonMm.z += 5;
            }));
    run(frame, 1000);
    assertEquals(1, device.lastForce().x, 1e-12);
    assertEquals(0, device.lastTorque().length());
  }

  /** Notes what an effect learns. */
  private static final class Witness implements HapticEffect {
    private int resets;
    private double fastestMmPerSecond;

    @Override
    public void add(HandState seen, Vec3 forceNewton, Vec3 torqueNewtonMm) {
      fastestMmPerSecond = Math.max(fastestMmPerSecond, seen.velocityMmPerSecond.length());
    }

    @Override
    public void reset() {
      resets++;
    }
  }

  @Test
  void aJumpOfTheDeviceIsNoMotionOfTheHandAndEffectsBeginAnew() {
    Witness witness = new Witness();
    PointFrame frame = floor.frame(device);
    frame.requestEffects(List.of(witness));
    run(frame, 10);
    int resets = witness.resets;
    device.script =
        (read, state) -> {
          state.relocated = read == 10;
          return fresh(state, read, 16, 16, 30);
        };
    run(frame, 10);
    assertTrue(frame.point().position.z == 30 && frame.statistics().freed() == 1);
    assertEquals(resets + 1, witness.resets);
    assertEquals(0, witness.fastestMmPerSecond);
    device.script = (read, state) -> fresh(state, read, 16, 16, 30 - 0.01 * (read - 20));
    run(frame, 200);
    assertEquals(10, witness.fastestMmPerSecond, 0.1, "0.01 mm in each millisecond");
  }

  @Test
  void anObserverSeesThePressingForceWithoutThatOfEffects() {
    PointFrame frame = floor.frame(device);
    double[] pressing = {Double.NaN};
    frame.observe(record -> pressing[0] = record.pressingNewton);
    frame.requestEffects(made(axis()));
    run(frame, 5);
    assertEquals(0, pressing[0], "nothing is touched");
    hand.set(16, 16, 6);
    run(frame, 500);
    assertEquals(0.5 * 2, pressing[0], 1e-5, "stiffness times depth");
    assertEquals(Math.hypot(6 * STIFFNESS, 0.5 * 2), device.lastForce().length(), 1e-5);
  }

  @Test
  void aGuideAddsToContactAndLeavesThePointAlone() {
    PointFrame plain = floor.frame(device);
    hand.set(16, 16, 6);
    run(plain, 200);
    Vec3 contact = device.lastForce();
    Vec3 rest = new Vec3().set(plain.point().position);
    PointFrame guided = floor.frame(device);
    guided.requestEffects(made(axis()));
    hand.set(16, 16, 12);
    run(guided, 5);
    hand.set(16, 16, 6);
    run(guided, 500);
    assertEquals(rest.x, guided.point().position.x);
    assertEquals(contact.z, device.lastForce().z, 1e-12);
    assertEquals(-6 * STIFFNESS, device.lastForce().x, 1e-12);
  }

  @Test
  void theLimiterBoundsGuideAndContactTogether() {
    PointFrame frame =
        floor.frame(device, FrameSettings.live(device.specification(), ForceSettings.of(0.5, 0.2)));
    GuideStrength mad = new GuideStrength(OptionalDouble.of(1e6), OptionalDouble.of(1e6), INFINITE);
    frame.requestEffects(made(Guides.axis(new Vec3(), new Vec3(0, 0, 1), mad)));
    double slew = device.specification().maxForceNewton() / FrameSettings.FULL_FORCE_MS;
    Vec3 last = new Vec3();
    for (int n = 0; n < 400; n++) {
      hand.set(16 + 10 * Math.sin(n), 16, 4);
      run(frame, 1);
      assertTrue(device.lastForce().length() <= device.specification().maxForceNewton());
      double step = device.lastForce().sub(last, last).length();
      assertTrue(step <= slew * (1 + 1e-9), "frame " + n + " changed by " + step);
      last.set(device.lastForce());
    }
  }

  @Test
  void aGuideDoesNotCut() {
    PointFrame frame = floor.frame(device);
    frame.carve(CarveSettings.ofRate(100));
    hand.set(16, 16, 9);
    frame.requestEffects(made(Guides.plane(new Vec3(0, 0, 0), new Vec3(0, 0, 1), STRENGTH)));
    run(frame, 300);
    assertEquals(-9 * STIFFNESS, device.lastForce().z, 1e-12);
    hand.set(16, 16, 7.9995);
    long solid = floor.bits.solidCount();
    run(frame, 100); // 0.00025 N of contact cut 0.0025 mm^3; the guide's 2 N would cut 20
    assertEquals(solid, floor.bits.solidCount());
  }

  @Test
  void effectsThatComeBackDoNotSeeTheMotionThatTheyMissed() {
    PointFrame frame = floor.frame(device);
    Vec3 speed = new Vec3(9, 9, 9);
    List<HapticEffect> watching =
        List.of((state, force, torque) -> speed.set(state.velocityMmPerSecond));
    frame.requestEffects(watching);
    run(frame, 5);
    frame.requestEffects(List.of());
    run(frame, 300);
    hand.x = 26;
    run(frame, 5);
    frame.requestEffects(watching);
    run(frame, 1);
    assertEquals(0, speed.length());
    hand.x = 26.1;
    run(frame, 1);
    assertEquals(100 / 5.0, speed.x, 1e-9); // 1 ms of a smoothing over 4 ms
  }

  private ToolFrame toolFrame(BodyScene bodies) {
    RigidTool tool = ToolSampler.ofShape(RodShape.capsule(1, 4), 0.7);
    return new ToolFrame(
        device,
        bodies,
        new RigidSolver(bodies, tool, RigidSettings.of(8, Clearance.POINTS)),
        RigidCoupling.of(tool, 0.5),
        new FrameSettings(
            ForceSettings.of(0.5, 0), INFINITE, INFINITE, 0, 20 * MS, 64, INFINITE, INFINITE),
        EditQueue.ofBodies(bodies.grids()),
        ToolFramePublisher.NONE);
  }

  private BodyScene floorBody() {
    return new BodyScene(List.of(new Body("floor", floor.bits, Floor.GRID, Mobility.FIXED)));
  }

  @Test
  void aToolThatHangsOnAHingeFeelsForceAndTorqueBackToIt() {
    ToolFrame frame = toolFrame(floorBody());
    hand.set(16, 16, 20);
    run(frame, 2);
    frame.requestEffects(made(Guides.hinge(new Vec3(10, 16, 20), new Vec3(0, 1, 0), STRENGTH)));
    run(frame, 300);
    assertEquals(0, device.lastForce().length(), 1e-12);
    hand.x = 18;
    turn.setRotationVector(new Vec3(0, 0, 0.2));
    run(frame, 300);
    assertEquals(-2 * STIFFNESS, device.lastForce().x, 1e-9);
    assertTrue(device.lastTorque().z < -0.01, "torque " + device.lastTorque());
  }

  @Test
  void aBlindEffectSeesWhatTheHandDoes() {
    ToolFrame frame = toolFrame(floorBody());
    hand.set(16, 16, 6);
    Vec3 seen = new Vec3();
    Vec3 contact = new Vec3();
    double[] seconds = {0};
    frame.requestEffects(
        List.of(
            (state, force, torque) -> {
              seen.set(state.device.translation);
              contact.set(state.contactNewton);
              seconds[0] = state.seconds;
              assertTrue(state.isRigid);
              assertEquals(-1, state.heldBody);
            }));
    run(frame, 300);
    assertTrue(seen.sameBits(hand));
    assertTrue(contact.sameBits(device.lastForce()));
    assertEquals(0.001, seconds[0]);
  }

  @Test
  void framesWithoutEffectsHaveTheSameBitsAsFramesWhoseEffectsAreGone() {
    PointFrame plain = floor.frame(device);
    hand.set(16, 16, 12);
    run(plain, 5);
    hand.set(16.3, 15.9, 6.2);
    run(plain, 50);
    Vec3 expected = device.lastForce();
    PointFrame frame = floor.frame(device);
    frame.requestEffects(made(axis()));
    hand.set(16, 16, 12);
    run(frame, 300);
    frame.requestEffects(List.of());
    run(frame, 300);
    hand.set(16.3, 15.9, 6.2);
    run(frame, 50);
    assertTrue(device.lastForce().sameBits(expected));
  }

  @Test
  void aToolFeelsTheGreyValueUnderItsContact() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(n % 32, n / 32 % 32, n / 1024, n % 32 < 16 ? -100 : 1200);
    }
    double[] felt = new double[2];
    for (int side = 0; side < 2; side++) {
      ToolFrame frame = toolFrame(floorBody());
      frame.use(new GreyMaterials(values, GreyMaterials.CT));
      hand.set(side == 0 ? 8 : 24, 16, 14);
      run(frame, 5);
      hand.z = 9;
      run(frame, 400);
      assertTrue(frame.motion().contact());
      felt[side] = device.lastForce().z;
    }
    assertEquals(0.15 * felt[1], felt[0], 1e-3);
  }
}
