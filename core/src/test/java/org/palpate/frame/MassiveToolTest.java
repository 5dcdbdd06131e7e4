package org.palpate.frame;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.ReadStatus;
import org.palpate.edit.EditQueue;
import org.palpate.force.ForceSettings;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveTool;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;
import org.palpate.testing.ScriptedDevice;
import org.palpate.testing.Seeds;

/** A rod with mass on the springs of the coupling, above a floor at z = 8. */
class MassiveToolTest {
  private static final double K = 0.5;
  private static final Vec3 GRAVITY = new Vec3(0, 0, -9810);

  private final RigidTool rod = ToolSampler.ofShape(RodShape.capsule(1.5, 8), 1);
  private final RigidCoupling coupling = RigidCoupling.of(rod, K);
  private final Vec3 at = new Vec3(16, 16, 22);
  private final Quaternion turned = new Quaternion();
  private MassiveTool mass;
  private ToolFrame frame;
  private long nanos;

  private void prepare(double kg, Vec3 gravity, double friction) {
    BodyScene bodies =
        new BodyScene(List.of(new Body("floor", Floor.bits(), Floor.GRID, Mobility.FIXED)));
    ScriptedDevice device =
        new ScriptedDevice(
            (read, state) -> {
              state.positionMm.set(at);
              state.orientation.set(turned);
              state.timeNanos = nanos;
              return ReadStatus.FRESH;
            });
    FrameSettings unlimited =
        new FrameSettings(
            ForceSettings.of(K, friction),
            Double.POSITIVE_INFINITY,
            Double.POSITIVE_INFINITY,
            0,
            FrameSettings.NO_SILENCE,
            1);
    frame =
        new ToolFrame(
            device,
            bodies,
            new RigidSolver(bodies, rod, RigidSettings.ofWholeBodies(8, bodies, rod)),
            coupling,
            unlimited.withTorque(Double.POSITIVE_INFINITY),
            EditQueue.ofBodies(bodies.grids()),
            ToolFramePublisher.NONE);
    mass = new MassiveTool(rod, coupling, friction, new MassSettings(kg, gravity));
    frame.use(mass);
    nanos = 0;
  }

  private void run(int hertz) {
    frame.run(nanos);
    nanos += 1_000_000_000L / hertz;
  }

  @ParameterizedTest
  @CsvSource({"0.005, 1000", "0.05, 1000", "0.05, 10000", "1, 1000", "1, 5000"})
  void aToolHangsOnItsSpringByItsWeightAndRestsBitForBit(double kg, int hertz) {
    prepare(kg, GRAVITY, 0);
    if (kg == 1) {
      at.z = 29; // It sags by 20 mm, and may not meet the floor.
      mass = new MassiveTool(rod, coupling, 0, new MassSettings(kg, new Vec3(0, 0, -1000)));
      frame.use(mass);
    }
    for (int n = 0; n < 20 * hertz; n++) {
      run(hertz);
    }
    double weight = kg == 1 ? 1 : kg * 9.81;
    assertEquals(-weight, frame.forceNewton().z, 1e-6);
    assertEquals(at.z - weight / K, frame.motion().pose().translation.z, 1e-6);
    Pose before = new Pose().set(frame.motion().pose());
    for (int n = 0; n < 100; n++) {
      run(hertz);
      assertTrue(before.sameBits(frame.motion().pose()), "it rests");
    }
  }

  /** A step of the device: a damped oscillator has the frequency and decay of theory. */
  @ParameterizedTest
  @ValueSource(ints = {5000, 10_000})
  void aToolSwingsAsTheoryHasIt(int hertz) {
    prepare(0.2, new Vec3(), 0);
    for (int n = 0; n < 100; n++) {
      run(hertz);
    }
    at.x += 0.5;
    double omega = Math.sqrt(K * 1000 / 0.2);
    double zeta = 0.2;
    double damped = omega * Math.sqrt(1 - zeta * zeta);
    double worst = 0;
    for (int n = 1; n < hertz / 2; n++) {
      run(hertz);
      double t = (double) n / hertz;
      double swing = Math.cos(damped * t) + zeta * omega / damped * Math.sin(damped * t);
      double expected = at.x - 0.5 * Math.exp(-zeta * omega * t) * swing;
      worst = Math.max(worst, Math.abs(frame.motion().pose().translation.x - expected));
    }
    assertTrue(worst < 0.02, "mm: " + worst);
  }

  @Test
  void aToolTurnsSlowlyAboutItsShortAxisAndQuicklyAboutItsLongOne() {
    double[] angles = new double[2];
    for (int axis = 0; axis < 2; axis++) {
      turned.setIdentity();
      prepare(0.5, new Vec3(), 0);
      for (int n = 0; n < 10; n++) {
        run(1000);
      }
      turned.setRotationVector(axis == 0 ? new Vec3(0.2, 0, 0) : new Vec3(0, 0, 0.2));
      for (int n = 0; n < 10; n++) {
        run(1000);
      }
      angles[axis] = frame.motion().pose().rotation.angle();
    }
    assertTrue(angles[0] > 0 && angles[1] > 3 * angles[0], angles[0] + " " + angles[1]);
  }

  /** A hand that comes back has never got energy from the tool, whatever it met meanwhile. */
  @ParameterizedTest
  @CsvSource({"0.005, 1000", "0.05, 1000", "0.05, 10000", "1, 1000"})
  void aToolGivesNoEnergyInContactEither(double kg, int hertz) {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    at.set(16, 16, 22);
    prepare(kg, new Vec3(), 0);
    run(hertz);
    Vec3 speed = new Vec3();
    Vec3 spin = new Vec3();
    double work = 0;
    double least = 0;
    boolean touched = false;
    for (int n = 0; n < 20 * hertz; n++) {
      double dt = 1.0 / hertz;
      double goal = n / hertz % 2 == 0 ? 9 : 22;
      speed.set(
          speed.x + dt * (-8 * speed.x + 400 * random.nextDouble(-1, 1) + 40 * (16 - at.x)),
          speed.y + dt * (-8 * speed.y + 400 * random.nextDouble(-1, 1) + 40 * (16 - at.y)),
          speed.z + dt * (-8 * speed.z + 400 * random.nextDouble(-1, 1) + 40 * (goal - at.z)));
      Vec3 move = speed.mul(dt, new Vec3());
      at.add(move, at);
      Vec3 turn = new Vec3(random.nextDouble(-1, 1), random.nextDouble(-1, 1), 0);
      spin.set(0.999 * spin.x + 0.05 * turn.x, 0.999 * spin.y + 0.05 * turn.y, 0);
      Vec3 rotate = spin.mul(dt, new Vec3());
      new Quaternion().setRotationVector(rotate).multiply(turned, turned);
      turned.normalize();
      run(hertz);
      touched |= frame.motion().contact();
      work -= frame.forceNewton().dot(move) + frame.torqueNewtonMm().dot(rotate);
      least = Math.min(least, work);
    }
    assertTrue(touched, "it met the floor");
    assertTrue(least > -0.02, "seed " + Seeds.seed() + ": the hand got " + -least + " mJ");
  }
}
