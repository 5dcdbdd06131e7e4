package org.palpate.benchmarks.stability;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.device.DeviceState;
import org.palpate.device.ReadStatus;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;

/** The model of hand and handle, against the equations of its parts and their solutions. */
class HandleMotionTest {
  private static final long SEED = Long.getLong("palpate.seed", 20_261_129);
  private static final DeviceModel DEVICE = new DeviceModel("test", 9, 0.5, 0.2, 1.5, 1e-9);
  private static final Grip HELD = new Grip("held", 0.3, 700, 4, 250, 6, 0.25);
  private static final Grip LOOSE = new Grip("loose", 0.1, 0, 0, 0, 1, 0);
  private static final Reach REACH = new Reach(new Vec3(2, 3, 10), new Vec3(2, 3, -10), 0.5, 1.5);

  private final SplittableRandom random = new SplittableRandom(SEED);

  private double[] randomState(int axes) {
    return random.doubles(4L * axes, -0.1, 0.1).toArray();
  }

  /** The state is handle position and velocity, hand position and velocity, an axis each. */
  @Test
  void theRatesAreThoseOfTwoMassesOnSpringsAndDampers() {
    HandleMotion motion = new HandleMotion(DEVICE, HELD, REACH);
    assertEquals(3, motion.axes());
    assertEquals(12, motion.getDimension());
    Vec3 force = new Vec3(0.4, -1.1, 2.2);
    motion.setForce(force, new Vec3());
    for (int n = 0; n < 200; n++) {
      double seconds = random.nextDouble(-0.1, 2.7);
      double[] state = randomState(3);
      double[] rates = motion.computeDerivatives(seconds, state);
      for (int axis = 0; axis < 3; axis++) {
        double handle = state[axis];
        double handleSpeed = state[3 + axis];
        double hand = state[6 + axis];
        double handSpeed = state[9 + axis];
        double from = REACH.awayMm().get(axis) / 1e3;
        double way = (REACH.pressedMm().get(axis) - REACH.awayMm().get(axis)) / 1e3;
        double goal = from + REACH.fraction(seconds) * way;
        double goalSpeed = REACH.fractionRate(seconds) * way;
        double press = axis == 2 ? -0.25 * REACH.fraction(seconds) : 0;
        double grip = 700 * (hand - handle) + 4 * (handSpeed - handleSpeed);
        double arm = 250 * (goal - hand) + 6 * (goalSpeed - handSpeed);
        double onHandle = force.get(axis) + press + grip - 1.5 * handleSpeed;
        assertEquals(handleSpeed, rates[axis]);
        assertEquals(handSpeed, rates[6 + axis]);
        assertEquals(onHandle / 0.2, rates[3 + axis], 1e-9, "axis " + axis);
        assertEquals((arm - grip) / 0.3, rates[9 + axis], 1e-9, "axis " + axis);
      }
    }
  }

  /** A rotation has masses and springs times the squared grip radius, so that it cancels. */
  @Test
  void aTorqueTurnsTheHandleAsAForceAtTheGripRadiusMovesIt() {
    HandleMotion motion = HandleMotion.turning(DEVICE, HELD, REACH);
    assertEquals(6, motion.axes());
    double radius = Grip.RADIUS_MM / 1e3;
    motion.setForce(new Vec3(1, 2, 3), new Vec3(4 * radius, 5 * radius, 6 * radius));
    double[] rates = motion.computeDerivatives(0, new double[24]);
    HandleMotion still = HandleMotion.turning(DEVICE, HELD, REACH);
    double[] withoutForce = still.computeDerivatives(0, new double[24]);
    for (int axis = 0; axis < 3; axis++) {
      assertEquals((axis + 1) / 0.2, rates[6 + axis] - withoutForce[6 + axis], 1e-9);
      assertEquals((axis + 4) / radius / 0.2, rates[9 + axis], 1e-9, "rad/s^2");
    }
  }

  @Test
  void theMotionStartsAtRestAwayFromTheSurface() {
    double[] start = HandleMotion.turning(DEVICE, HELD, REACH).start();
    for (int axis = 0; axis < 3; axis++) {
      assertEquals(REACH.awayMm().get(axis) / 1e3, start[axis]);
      assertEquals(REACH.awayMm().get(axis) / 1e3, start[12 + axis]);
      assertEquals(0, start[3 + axis]);
      assertEquals(0, start[6 + axis]);
    }
    double[] rates = HandleMotion.turning(DEVICE, HELD, REACH).computeDerivatives(0, start);
    for (double rate : rates) {
      assertEquals(0, rate, 1e-12, "and nothing moves it");
    }
  }

  private static Plant plant(Sampling sampling, DeviceModel device) {
    return new Plant(
        device, sampling, REACH, 1, new HandleMotion(device, LOOSE, REACH), new Quaternion());
  }

  /** A mass under a constant force with damping b approaches the speed F / b exponentially. */
  @Test
  void aLooseHandleUnderAConstantForceMovesAsItsFormulaSays() {
    Plant plant = plant(new Sampling(1_000, 0), DEVICE);
    DeviceState sample = new DeviceState();
    Vec3 newton = new Vec3(0.6, 0, -0.3);
    plant.read(sample);
    for (int n = 1; n <= 400; n++) {
      plant.write(newton, new Vec3());
      assertEquals(ReadStatus.FRESH, plant.read(sample));
      double seconds = n * 1e-3;
      double rate = 1.5 / 0.2;
      double reached = (seconds - (1 - Math.exp(-rate * seconds)) / rate) / 1.5 * 1e3;
      assertEquals(2 + 0.6 * reached, sample.positionMm.x, 1e-6, "mm at " + seconds + " s");
      assertEquals(3, sample.positionMm.y, 1e-6);
      assertEquals(10 - 0.3 * reached, sample.positionMm.z, 1e-6);
      assertEquals(n * 1_000_000L, sample.timeNanos);
    }
    double work = 0.6 * (sample.positionMm.x - 2) - 0.3 * (sample.positionMm.z - 10);
    assertEquals(work / 1e3, plant.maxEnergyJoule(), 1e-9, "J: force times way");
  }

  @Test
  void theLargestEnergyStaysAfterTheHandleGaveSomeBack() {
    Plant plant = plant(new Sampling(1_000, 0), DEVICE);
    DeviceState sample = new DeviceState();
    plant.read(sample);
    for (int n = 0; n < 200; n++) {
      plant.write(new Vec3(0.5, 0, 0), new Vec3());
      plant.read(sample);
    }
    double most = plant.maxEnergyJoule();
    assertTrue(most > 0);
    for (int n = 0; n < 20; n++) {
      plant.write(new Vec3(-0.5, 0, 0), new Vec3());
      plant.read(sample);
    }
    assertEquals(most, plant.maxEnergyJoule(), "the force braked the handle");
  }

  @Test
  void theSteepestForceIsTheLargestChangeOverTheTimeOfAFrame() {
    Plant plant = plant(new Sampling(2_000, 0), DEVICE);
    plant.write(new Vec3(0, 0.3, 0), new Vec3());
    assertEquals(0.6, plant.steepestNewtonPerMs(), 1e-12, "half a millisecond a frame");
    plant.write(new Vec3(0, 0.3, 0.4), new Vec3());
    assertEquals(0.8, plant.steepestNewtonPerMs(), 1e-12);
    plant.write(new Vec3(0, 0.3, 0.5), new Vec3());
    assertEquals(0.8, plant.steepestNewtonPerMs(), 1e-12);
  }

  @Test
  void encodersShowWholeSteps() {
    DeviceModel coarse = new DeviceModel("coarse", 9, 0.5, 0.2, 1.5, 0.25);
    Plant plant = plant(new Sampling(1_000, 0), coarse);
    DeviceState sample = new DeviceState();
    plant.read(sample);
    double farthest = 0;
    for (int n = 0; n < 300; n++) {
      plant.write(new Vec3(1, 0, 0), new Vec3());
      plant.read(sample);
      double steps = sample.positionMm.x / 0.25;
      assertEquals(Math.rint(steps), steps, 1e-9);
      farthest = Math.max(farthest, sample.positionMm.x);
    }
    assertTrue(farthest > 3, "it moved: " + farthest);
  }

  @Test
  void theDeviceIsGoneWhenTheMotionIsOver() {
    Plant plant = plant(new Sampling(1_000, 0), DEVICE);
    DeviceState sample = new DeviceState();
    int frames = 0;
    while (plant.read(sample) == ReadStatus.FRESH) {
      plant.write(new Vec3(), new Vec3());
      frames++;
    }
    assertEquals(2_500, frames, 1, "0.5 s in, 1.5 s there, 0.5 s out");
  }

  @Test
  void theSpecificationIsThatOfTheModel() {
    Plant straight = plant(new Sampling(1_000, 0), DEVICE);
    assertEquals(9, straight.specification().maxForceNewton());
    assertEquals(0.5, straight.specification().maxStiffnessNewtonPerMm());
    assertEquals(0, straight.specification().maxTorqueNewtonMm());
    Plant turning =
        new Plant(
            DEVICE,
            new Sampling(1_000, 0),
            REACH,
            1,
            HandleMotion.turning(DEVICE, LOOSE, REACH),
            new Quaternion());
    assertEquals(9 * Grip.RADIUS_MM, turning.specification().maxTorqueNewtonMm());
  }
}
