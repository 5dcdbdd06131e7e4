package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;
import org.palpate.testing.Seeds;
import org.palpate.volume.ScalarVolume;

/** A plate that lies on a floor, held with a stiffness of 0.5 N/mm. */
class ToolForceTest {
  private static final double STIFFNESS = 0.5;
  private static final double MU = 0.4;
  private static final double SLIDING = 0.3;
  private static final long MS = 1_000_000;

  private final Body floor = new Body("floor", Floor.bits(), Floor.GRID, Mobility.FIXED);
  private final BodyScene bodies = new BodyScene(List.of(floor));
  private final RigidTool plate = ToolSampler.ofShape(new BoxShape(8, 8, 2), 0.7);
  private final ToolMotion motion = new ToolMotion();
  private final Pose device = new Pose();
  private final Vec3 force = new Vec3();
  private final Vec3 torque = new Vec3();
  private RigidSolver solver;
  private ToolForce toolForce;

  private void hold(double friction, double sliding, double damping) {
    Material general = new Material(STIFFNESS, friction, sliding, damping);
    hold(new ForceSettings(general, FrictionForm.CONE, true, List.of()));
  }

  private RigidCoupling spring() {
    return RigidCoupling.of(plate, STIFFNESS);
  }

  /** Presses the plate onto the floor and lets it settle. */
  private void hold(ForceSettings settings) {
    hold(new ToolForce(plate, 1, spring(), settings));
  }

  private void hold(ToolForce newForce) {
    hold(newForce, RigidSettings.ofWholeBodies(8, bodies, plate));
  }

  private void hold(ToolForce newForce, RigidSettings clearances) {
    solver = new RigidSolver(bodies, plate, clearances);
    toolForce = newForce;
    device.setIdentity();
    device.translation.set(16, 16, 14);
    solver.place(device, motion);
    while (device.translation.z > 7) {
      device.translation.z -= 0.1;
      frame(MS);
    }
    for (int n = 0; n < 60; n++) {
      frame(MS);
    }
  }

  private void frame(long elapsedNanos) {
    solver.follow(device, motion);
    toolForce.compute(motion, device, elapsedNanos, force, torque);
  }

  @Test
  void theContactsOfAPressedPlateShareTheForceAndPointUp() {
    hold(MU, SLIDING, 0);
    ToolContacts contacts = motion.contacts();
    assertTrue(contacts.count() > 0 && contacts.count() <= ToolContacts.MOST);
    double sum = 0;
    for (int n = 0; n < contacts.count(); n++) {
      sum += contacts.share(n);
      assertEquals(0, contacts.body(n));
      assertTrue(contacts.normal(n, new Vec3()).z > 0.99);
      assertEquals(-1, contacts.position(n, new Vec3()).z, 1e-9);
    }
    assertEquals(1, sum, 1e-12);
    device.translation.z = 14;
    frame(MS);
    frame(MS);
    assertEquals(0, motion.contacts().count());
  }

  @Test
  void aDraggedPlateSticksInsideTheConeAndSlidesAlongTheNarrowerOneBeyond() {
    hold(MU, SLIDING, 0);
    double pressing = force.z;
    assertTrue(pressing > 0.5, "pressing " + pressing);
    assertEquals(0, Math.hypot(force.x, force.y), 1e-6);
    for (int n = 0; n < 10; n++) {
      device.translation.x += 0.02;
      frame(MS);
    }
    assertEquals(-STIFFNESS * 0.2, force.x, 0.02);
    for (int n = 0; n < 200; n++) {
      device.translation.x += 0.02;
      frame(MS);
    }
    assertEquals(-SLIDING * force.z, force.x, 0.01 * force.z);
    for (int n = 0; n < 3; n++) {
      frame(MS);
    }
    double held = force.x;
    device.translation.x -= 0.01;
    frame(MS);
    assertTrue(held < -0.1 && force.x > -1e-3, "a hand that turns back is let go: " + force);
  }

  @Test
  void aTwistOfAPressedPlateIsResistedAboutTheNormal() {
    hold(0, 0, 0);
    assertEquals(0, twisted(), 1e-6);
    hold(MU, SLIDING, 0);
    double resisting = twisted();
    double most = SLIDING * force.z * Math.hypot(4, 4);
    assertTrue(resisting < -0.2 && resisting > -1.1 * most, resisting + " of " + most);
  }

  private double twisted() {
    for (int n = 1; n <= 100; n++) {
      device.rotation.setRotationVector(new Vec3(0, 0, 0.002 * n));
      frame(MS);
    }
    return torque.z;
  }

  @Test
  void frictionNeverPushesTheHandOn() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    hold(MU, SLIDING, 0);
    RigidCoupling coupling = RigidCoupling.of(plate, STIFFNESS);
    Vec3 plain = new Vec3();
    Vec3 plainTorque = new Vec3();
    Vec3 moved = new Vec3();
    double most = Double.NEGATIVE_INFINITY;
    double least = 0;
    for (int n = 0; n < 3000; n++) {
      moved.set(random.nextDouble(-0.04, 0.04), random.nextDouble(-0.04, 0.04), 0);
      device.translation.add(moved, device.translation);
      frame(MS);
      coupling.compute(motion.pose(), device, plain, plainTorque);
      double power = force.sub(plain, plain).dot(moved);
      most = Math.max(most, power);
      least = Math.min(least, power);
    }
    assertTrue(most < 1e-3 && least < -1e-3, "from " + least + " to " + most);
  }

  @Test
  void withoutFrictionAndDampingTheForceIsTheCouplingToTheBit() {
    hold(0, 0, 0);
    Vec3 plain = new Vec3();
    Vec3 plainTorque = new Vec3();
    RigidCoupling.of(plate, STIFFNESS).compute(motion.pose(), device, plain, plainTorque);
    assertTrue(force.sameBits(plain) && torque.sameBits(plainTorque));
    assertTrue(toolForce.frictionSkipped() > 100);
  }

  @Test
  void dampingOpposesTheHandAndIsNeverLongerThanTheCoupling() {
    hold(0, 0, 0);
    double resting = force.z;
    hold(0, 0, 0.005);
    assertEquals(resting, force.z, 1e-6);
    double inward = moving(-0.02);
    double still = moving(0);
    double outward = moving(0.02);
    assertTrue(inward > still + 0.03 && outward < still - 0.03, inward + " " + outward);
    hold(0, 0, 1000);
    double pressed = moving(-0.02);
    double stretch = motion.pose().translation.z - device.translation.z;
    assertEquals(2 * STIFFNESS * stretch, pressed, 1e-9);
    assertEquals(0, moving(0.02), 1e-9);
  }

  private double moving(double mmPerMs) {
    for (int n = 0; n < 20; n++) {
      device.translation.z += mmPerMs;
      frame(MS);
    }
    return force.z;
  }

  @Test
  void theTouchedBodyGivesStiffnessAndFriction() {
    Material general = new Material(STIFFNESS, 0, 0, 0);
    Material floorAlone = new Material(2 * STIFFNESS, MU, SLIDING, 0);
    hold(new ForceSettings(general, FrictionForm.CONE, true, List.of(floorAlone)));
    double stretch = motion.pose().translation.z - device.translation.z;
    assertEquals(2 * STIFFNESS * stretch, force.z, 1e-9);
    device.rotation.setRotationVector(new Vec3(0.02, 0, 0));
    frame(MS);
    Vec3 plain = new Vec3();
    Vec3 plainTorque = new Vec3();
    RigidCoupling.of(plate, STIFFNESS).compute(motion.pose(), device, plain, plainTorque);
    assertTrue(Math.abs(plainTorque.x) > 0.01, "it resists the turn: " + plainTorque);
    assertEquals(2 * plainTorque.x, torque.x, 0.2 * Math.abs(torque.x));
    device.rotation.setIdentity();
    for (int n = 0; n < 100; n++) {
      device.translation.x += 0.02;
      frame(MS);
    }
    assertTrue(force.x < -0.25 * force.z, "force " + force);
  }

  private double stretchMm() {
    return motion.pose().translation.z - device.translation.z;
  }

  @Test
  void aResetForgetsTheAnchors() {
    hold(MU, SLIDING, 0);
    stick();
    toolForce.reset();
    frame(MS);
    assertEquals(0, force.x, 1e-6);
  }

  /** Drags the plate a little, so that its friction pulls back. */
  private void stick() {
    for (int n = 0; n < 10; n++) {
      device.translation.x += 0.02;
      frame(MS);
    }
    assertTrue(force.x < -0.05, "it sticks: " + force);
  }

  @Test
  void frictionEndsWhereThePlateIsLifted() {
    hold(MU, SLIDING, 0);
    stick();
    double pressedAt = device.translation.z;
    device.translation.z = 14;
    for (int n = 0; n < 20; n++) {
      frame(MS);
    }
    assertEquals(0, force.length(), 1e-6, "in free space");
    while (device.translation.z > pressedAt) {
      device.translation.z -= 0.1;
      frame(MS);
    }
    assertEquals(0, force.x, 0.01, "the next contact begins with a new anchor");
  }

  @Test
  void frictionThatWasSwitchedOffBeginsAnew() {
    hold(MU, SLIDING, 0);
    stick();
    toolForce.change(ForceSettings.of(STIFFNESS, 0));
    frame(MS);
    assertEquals(0, force.x, 1e-6, "smooth");
    toolForce.change(
        new ForceSettings(
            new Material(STIFFNESS, MU, SLIDING, 0), FrictionForm.CONE, true, List.of()));
    frame(MS);
    assertEquals(0, force.x, 1e-6, "the anchors are new");
  }

  @Test
  void aHandThatTakesOverHasNoSpeedYet() {
    hold(0, 0, 0.005);
    moving(-0.02);
    assertTrue(force.z > STIFFNESS * stretchMm() + 0.05, "it is damped: " + force);
    toolForce.takeOver();
    device.translation.z -= 0.02;
    frame(MS);
    assertEquals(STIFFNESS * stretchMm(), force.z, 1e-9);
    double before = force.z;
    frame(MS);
    assertEquals(before, force.z, 1e-9, "a hand at rest");
  }

  /** Tilts the hand by 1 rad/s and returns the torque. */
  private double tilted() {
    for (int n = 1; n <= 40; n++) {
      device.rotation.setRotationVector(new Vec3(0.001 * n, 0, 0));
      frame(MS);
    }
    return torque.length();
  }

  @Test
  void dampingResistsATurnByTheSquaredRadiusOfTheTool() {
    hold(0, 0, 0);
    double plain = tilted();
    hold(0, 0, 0.005);
    double damped = tilted();
    double expected = 0.005 * plate.rmsRadiusMm() * plate.rmsRadiusMm();
    assertEquals(expected, damped - plain, 0.1 * expected, plain + " to " + damped);
    toolForce.takeOver();
    frame(MS);
    assertEquals(plain, torque.length(), 0.1 * expected, "another hand has not turned yet");
  }

  /** The values rise by 100 a voxel, and the stiffness with them. */
  @Test
  void theGreyValueInsideTheBodyGivesTheMaterialWhateverTheClearance() {
    ScalarVolume values = ScalarVolume.of(Floor.GRID, ScalarVolume.Storage.INT16);
    for (int n = 0; n < 32 * 32 * 32; n++) {
      values.set(n % 32, n / 32 % 32, n / 1024, 100 * (n / 1024));
    }
    List<GreyMaterials.Row> rows =
        List.of(new GreyMaterials.Row(0, 0, 0, 0), new GreyMaterials.Row(3000, 1, 0, 0));
    GreyMaterials materials = new GreyMaterials(values, rows);
    for (RigidSettings settings :
        List.of(
            RigidSettings.of(8, Clearance.POINTS),
            RigidSettings.ofWholeBodies(8, bodies, plate),
            RigidSettings.of(8, Clearance.ofWholeBody(plate, Floor.GRID, 1.5)))) {
      ToolForce greys = new ToolForce(plate, 1, spring(), ForceSettings.of(STIFFNESS, 0));
      greys.use(materials);
      hold(greys, settings);
      assertTrue(stretchMm() > 0.5, "the plate is pressed by " + stretchMm());
      double readZ = 0.5 + 30 * force.z / (STIFFNESS * stretchMm());
      assertTrue(
          readZ >= Floor.TOP - 1 - 1e-6 && readZ <= Floor.TOP - 0.5,
          readZ + " " + settings.clearances());
    }
  }

  @Test
  void aCouplingWithoutStiffnessGivesNoForce() {
    ForceSettings soft = ForceSettings.of(0, 0);
    hold(new ToolForce(plate, 1, RigidCoupling.of(plate, 0), soft));
    assertEquals(0, force.length());
    assertEquals(0, torque.length());
  }
}
