package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.device.DeviceDecorator;
import org.palpate.device.DeviceSpecification;
import org.palpate.device.DeviceState;
import org.palpate.device.HandTarget;
import org.palpate.device.ReadStatus;
import org.palpate.device.SimulatedDevice;
import org.palpate.elastic.ElasticBody;
import org.palpate.elastic.SynchronousUpdates;
import org.palpate.elastic.lattice.ControlLattice;
import org.palpate.elastic.lattice.ElasticMaterial;
import org.palpate.elastic.lattice.ElasticSegment;
import org.palpate.force.ForceSettings;
import org.palpate.force.FrictionForm;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveContact;
import org.palpate.force.Material;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;
import org.palpate.volume.BitCube;

/** Frames at 1, 5 and 10 kHz: what the hand feels does not depend on the rate. */
class FrameRateTest {
  private static final long SECOND = 1_000_000_000;

  private final Floor floor = Floor.make();

  private PointFrame frame(org.palpate.device.HapticDevice device, ForceSettings force) {
    return new PointFrame(
        GridDevice.inGridCoordinates(device),
        new SmoothSolver(Floor.METRIC, 8),
        floor.scene,
        Floor.METRIC,
        FrameSettings.live(device.specification(), force),
        floor.edits,
        FramePublisher.NONE);
  }

  /** A device of one sample in a millisecond that jumps into the floor after a second. */
  private static DeviceDecorator slow(long[] nowNanos) {
    ScriptedDevice plain = ScriptedDevice.at(16, 16, 12);
    return new DeviceDecorator(plain) {
      private long delivered = -1;

      @Override
      public DeviceSpecification specification() {
        return new DeviceSpecification("slow", "", 10, 100, 100, 1_000_000);
      }

      @Override
      public ReadStatus read(DeviceState state) {
        long sample = nowNanos[0] / 1_000_000;
        boolean isNew = sample > delivered;
        delivered = sample;
        double z = nowNanos[0] < SECOND ? 12 : 4;
        ScriptedDevice.fresh(state, sample, 16, 16, z);
        return isNew ? ReadStatus.FRESH : ReadStatus.REPEATED;
      }
    };
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 5000, 10_000})
  void theForceOfASlowDeviceRisesAsFastAtEveryRate(int hertz) {
    long[] now = {0};
    PointFrame frame = frame(slow(now), new ForceSettings(50, 0, FrictionForm.CONE, true));
    long reached = 0;
    for (; now[0] < SECOND + SECOND / 10 && reached == 0; now[0] += SECOND / hertz) {
      frame.run(now[0]);
      reached = frame.forceNewton().length() > 9.99 ? now[0] : 0;
    }
    // From zero to the device's maximum within 4 ms, in steps of a millisecond.
    assertEquals(3, (reached - SECOND) / 1e6, 1.01);
  }

  private static double slide(PointFrame frame, ScriptedDevice device, int hertz) {
    return slide(frame, device, hertz, () -> {});
  }

  private static double slide(
      PointFrame frame, ScriptedDevice device, int hertz, Runnable beforeFrame) {
    double sum = 0;
    for (int n = 0; n < hertz; n++) {
      double t = (double) n / hertz;
      double depth = Math.min(2, 8 * t);
      double x = 8 + 8 * t;
      device.script =
          (read, state) -> {
            ScriptedDevice.fresh(state, 0, x, 16, 10 - depth - 1.5);
            state.timeNanos = Math.round(t * SECOND);
            return ReadStatus.FRESH;
          };
      beforeFrame.run();
      frame.run(Math.round(t * SECOND));
      sum += frame.forceNewton().length() / hertz;
    }
    return sum;
  }

  @ParameterizedTest
  @ValueSource(ints = {5000, 10_000})
  void aSlideWithFrictionAndDampingHasTheSameMeanForce(int hertz) {
    Material rough = new Material(0.5, 0.4, 0.3, 0.002);
    ForceSettings force = new ForceSettings(rough, FrictionForm.CONE, true, List.of(rough));
    ScriptedDevice device = ScriptedDevice.at(8, 16, 12);
    double slow = slide(frame(device, force), device, 1000);
    double fast = slide(frame(device, force), device, hertz);
    assertTrue(slow > 0.2, "it presses: " + slow);
    assertEquals(slow, fast, 0.02 * slow);
  }

  @ParameterizedTest
  @ValueSource(ints = {5000, 10_000})
  void aBodyWithMassFallsAndRestsAsAtAKilohertz(int hertz) {
    double slow = sag(1000);
    assertEquals(slow, sag(hertz), 1e-3);
    assertEquals(0.05 * 9.81, slow, 1e-3);
  }

  private double sag(int hertz) {
    ScriptedDevice device = ScriptedDevice.at(16, 16, 20);
    ForceSettings force = ForceSettings.of(0.5, 0);
    PointFrame frame = frame(device, force);
    Vec3 gravity = new Vec3(0, 0, -9810);
    frame.give(new MassiveContact(Floor.METRIC, force, new MassSettings(0.05, gravity)));
    for (int n = 0; n < 2 * hertz; n++) {
      frame.run(n * SECOND / hertz);
    }
    return -frame.forceNewton().z;
  }

  /** Presses into a soft layer on a base that stands still, slides, and returns the mean force. */
  private double slideOnSoftLayer(int hertz) {
    BitCube base = new BitCube(Floor.EDGE, Floor.EDGE, Floor.EDGE);
    BitCube layer = Floor.bits();
    for (int n = 0; n < Floor.EDGE * Floor.EDGE * 2; n++) {
      int i = n % Floor.EDGE;
      int j = n / Floor.EDGE % Floor.EDGE;
      base.set(i, j, n / (Floor.EDGE * Floor.EDGE));
      layer.clear(i, j, n / (Floor.EDGE * Floor.EDGE));
    }
    ElasticSegment soft = new ElasticSegment(layer, new ElasticMaterial(20e3, 0.4));
    ElasticBody body =
        new ElasticBody(
            new ControlLattice(Floor.METRIC, List.of(soft), List.of(base), 4), Floor.METRIC);
    SynchronousUpdates updates = new SynchronousUpdates(body, 1000.0 / hertz);
    ScriptedDevice device = ScriptedDevice.at(8, 16, 12);
    PointFrame frame = frame(device, ForceSettings.of(0.5, 0.3));
    frame.deform(body.contact().paced(SECOND / hertz));
    return slide(frame, device, hertz, updates::beforeFrame);
  }

  @ParameterizedTest
  @ValueSource(ints = {5000, 10_000})
  void aSlideOnASoftLayerHasTheSameMeanForce(int hertz) {
    double slow = slideOnSoftLayer(1000);
    assertTrue(slow > 0.05, "it presses: " + slow);
    assertEquals(slow, slideOnSoftLayer(hertz), 0.01 * slow);
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 5000, 10_000})
  void elasticSegmentsAreUpdatedThirtyTimesASecond(int hertz) {
    ElasticSegment soft = new ElasticSegment(floor.bits, new ElasticMaterial(20e3, 0.4));
    ElasticBody body =
        new ElasticBody(
            new ControlLattice(Floor.METRIC, List.of(soft), List.of(), 16), Floor.METRIC);
    SynchronousUpdates updates = new SynchronousUpdates(body, 1000.0 / hertz);
    for (int n = 0; n < hertz; n++) {
      updates.beforeFrame();
    }
    assertEquals(30, body.counters().updates());
  }

  @ParameterizedTest
  @ValueSource(ints = {1000, 5000, 10_000})
  void aSimulatedHandIsAsFastAtEveryRate(int hertz) {
    HandTarget target = HandTarget.ofBox(new Vec3(2, 2, 2), new Vec3(30, 30, 12), 1);
    SimulatedDevice hand = new SimulatedDevice(7, target, SECOND / hertz);
    DeviceState state = new DeviceState();
    Vec3 last = new Vec3();
    double fastest = 0;
    for (int n = 0; n < 60 * hertz; n++) {
      hand.read(state);
      double mm = state.positionMm.sub(last, new Vec3()).length();
      fastest = n > 0 ? Math.max(fastest, mm * hertz / 1000) : 0;
      last.set(state.positionMm);
    }
    // A stroke's highest speed is 15/8 of its mean one, which is 5 to 50 voxels in a millisecond.
    assertTrue(fastest > 5 && fastest < 1.1 * 50 * 15 / 8, "mm/ms: " + fastest);
  }
}
