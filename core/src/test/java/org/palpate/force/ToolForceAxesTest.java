package org.palpate.force;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.RigidSettings;
import org.palpate.rigid.RigidSolver;
import org.palpate.rigid.ToolContacts;
import org.palpate.rigid.ToolMotion;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Floor;

/** Turns floor, plate and hand together, so that the floor's normal is each axis in turn. */
class ToolForceAxesTest {
  private static final double STIFFNESS = 0.5;
  private static final long MS = 1_000_000;

  /** A plate and a floor that are turned together. */
  private static final class Session {
    final Quaternion turn;
    final RigidTool plate = ToolSampler.ofShape(new BoxShape(8, 6, 2), 0.7);
    final ToolMotion motion = new ToolMotion();
    final RigidSolver solver;
    final ToolForce toolForce;
    final Pose device = new Pose();
    final Vec3 force = new Vec3();
    final Vec3 torque = new Vec3();

    /** The hand in the coordinates of a floor that is not turned. */
    final Pose hand = new Pose();

    Session(Quaternion turn, Material material) {
      this.turn = turn;
      Body floor = new Body("floor", Floor.bits(), Floor.GRID, Mobility.FIXED);
      floor.setPose(new Pose().set(new Vec3(), turn));
      BodyScene bodies = new BodyScene(List.of(floor));
      solver = new RigidSolver(bodies, plate, RigidSettings.ofWholeBodies(8, bodies, plate));
      toolForce =
          new ToolForce(
              plate,
              1,
              RigidCoupling.of(plate, STIFFNESS),
              new ForceSettings(material, FrictionForm.CONE, true, List.of()));
      hand.translation.set(16, 16, 14);
      place();
      solver.place(device, motion);
      while (hand.translation.z > 7) {
        hand.translation.z -= 0.1;
        frame();
      }
      for (int n = 0; n < 60; n++) {
        frame();
      }
    }

    private void place() {
      turn.rotate(hand.translation, device.translation);
      turn.multiply(hand.rotation, device.rotation);
    }

    void frame() {
      place();
      solver.follow(device, motion);
      toolForce.compute(motion, device, MS, force, torque);
    }

    /** Returns force and torque in the coordinates of a floor that is not turned. */
    double[] felt() {
      Vec3 f = turn.inverseRotate(force, new Vec3());
      Vec3 t = turn.inverseRotate(torque, new Vec3());
      return new double[] {f.x, f.y, f.z, t.x, t.y, t.z};
    }
  }

  private static Quaternion cyclic(int times) {
    Quaternion turn = new Quaternion();
    for (int n = 0; n < times; n++) {
      turn.multiply(new Quaternion(0.5, 0.5, 0.5, 0.5), turn);
    }
    return turn;
  }

  /** Moves a hand in a way and returns what it feels in each frame. */
  private static double[][] felt(Quaternion turn, Material material, double[] velocity, int count) {
    Session session = new Session(turn, material);
    double[][] felt = new double[count][];
    Vec3 rotation = new Vec3();
    for (int n = 0; n < count; n++) {
      Vec3 at = session.hand.translation;
      at.set(at.x + velocity[0], at.y + velocity[1], at.z + velocity[2]);
      rotation.set(velocity[3], velocity[4], velocity[5]).mul(n + 1.0, rotation);
      session.hand.rotation.setRotationVector(rotation);
      session.frame();
      felt[n] = session.felt();
    }
    return felt;
  }

  @ParameterizedTest
  @CsvSource({"0.02, 0, 0", "0, 0.02, 0", "0.015, -0.01, 0", "0.01, 0.004, -0.005", "0, 0, 0.03"})
  void theForceTurnsWithTheScene(double x, double y, double z) {
    double[] velocity = {x, y, z, 0, 0, 0};
    Material rough = new Material(STIFFNESS, 0.4, 0.3, 0.002);
    double[][] upright = felt(cyclic(0), rough, velocity, 150);
    for (int times = 1; times <= 2; times++) {
      double[][] turned = felt(cyclic(times), rough, velocity, 150);
      for (int n = 0; n < upright.length; n++) {
        for (int c = 0; c < 6; c++) {
          double tolerance = c < 3 ? 0.01 : 0.05;
          assertEquals(upright[n][c], turned[n][c], tolerance, times + " frame " + n + " c " + c);
        }
      }
    }
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void aDragIsOpposedAlongItsOwnDirectionWhateverTheNormal(int times) {
    double[][] along = felt(cyclic(times), new Material(STIFFNESS, 0.4, 0.3, 0), drag(1, 0), 200);
    double[] last = along[along.length - 1];
    assertEquals(-0.3 * last[2], last[0], 0.02 * last[2], "sliding friction along x");
    assertEquals(0, last[1], 0.02 * last[2]);
    double[][] across = felt(cyclic(times), new Material(STIFFNESS, 0.4, 0.3, 0), drag(0, -1), 200);
    last = across[across.length - 1];
    assertEquals(0.3 * last[2], last[1], 0.02 * last[2], "sliding friction along y");
    assertEquals(0, last[0], 0.02 * last[2]);
  }

  /** Rounding decides which of equal sample points carry the plate, and so the torque a little. */
  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void aTwistIsResistedAboutTheNormalWhateverItIs(int times) {
    double[][] twist =
        felt(
            cyclic(times),
            new Material(STIFFNESS, 0.4, 0.3, 0),
            new double[] {0, 0, 0, 0, 0, 0.002},
            100);
    double[] last = twist[twist.length - 1];
    double most = 0.3 * last[2] * Math.hypot(4, 3);
    assertTrue(last[5] < -0.2 && last[5] > -1.1 * most, last[5] + " of " + most);
    assertTrue(Math.hypot(last[0], last[1]) < 0.25 * last[2], "a twist hardly drags");
  }

  private static double[] drag(double x, double y) {
    return new double[] {0.02 * x, 0.02 * y, 0, 0, 0, 0};
  }

  @ParameterizedTest
  @CsvSource({"0", "1", "2"})
  void aPulledAnchorIsAsStiffAsTheCoupling(int times) {
    double[][] stuck = felt(cyclic(times), new Material(STIFFNESS, 5, 5, 0), drag(1, 2), 20);
    double[] last = stuck[stuck.length - 1];
    assertEquals(-STIFFNESS * 0.4, last[0], 0.03);
    assertEquals(-STIFFNESS * 0.8, last[1], 0.03);
  }

  @Test
  void contactsLieOnTheFloorWhateverItsNormal() {
    for (int times = 0; times < 3; times++) {
      Session session = new Session(cyclic(times), new Material(STIFFNESS, 0.4, 0.3, 0));
      ToolContacts contacts = session.motion.contacts();
      assertTrue(contacts.count() > 0, "times " + times);
      for (int n = 0; n < contacts.count(); n++) {
        Vec3 normal = session.turn.inverseRotate(contacts.normal(n, new Vec3()), new Vec3());
        assertEquals(1, normal.z, 1e-3, "times " + times);
      }
    }
  }
}
