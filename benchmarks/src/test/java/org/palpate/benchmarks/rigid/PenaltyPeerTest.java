package org.palpate.benchmarks.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayDeque;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * The penalty method of 1999, with which this project is compared: it must be as good as its
 * authors describe it. A ball is pressed onto a floor whose upper face is z = 20.
 */
class PenaltyPeerTest {
  private static final int EDGE = 48;
  private static final double TOP = 20;
  private static final double RADIUS_MM = 6;

  private final RigidTool ball = MeasuredTools.ball(RADIUS_MM);
  private final PenaltyPeer peer = new PenaltyPeer(floor(), ball);
  private final Pose device = Pose.at(24, 24, 40);

  private static BitCube floor() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    for (int n = 0; n < EDGE * EDGE * (int) TOP; n++) {
      bits.set(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
    }
    return bits;
  }

  private void follow(int frames) {
    for (int n = 0; n < frames; n++) {
      peer.follow(device);
    }
  }

  /** Returns the middle of the points, which is the centre of the ball. */
  private Vec3 centre() {
    Vec3 sum = new Vec3();
    for (int n = 0; n < peer.count(); n++) {
      sum.add(peer.point(n, new Vec3()), sum);
    }
    return sum.mul(1.0 / peer.count(), sum);
  }

  /**
   * A mass of 0.1 kg on a spring of 1,000 N/m with critical damping, stepped once a millisecond.
   */
  @Test
  void awayFromTheFloorTheBallFollowsTheDeviceAsACriticallyDampedMass() {
    peer.place(Pose.at(24, 24, 40));
    double damping = 2 * Math.sqrt(1_000 * 0.1);
    double metres = 0;
    double speed = 0;
    double lastGoal = 0;
    double farthest = 0;
    for (int frame = 0; frame < 800; frame++) {
      double goal = 1e-3 * Math.min(3, 0.01 * frame);
      device.translation.x = 24 + 1e3 * goal;
      peer.follow(device);
      double newton = 1_000 * (goal - metres) + damping * ((goal - lastGoal) / 1e-3 - speed);
      speed += newton / 0.1 * 1e-3;
      metres += speed * 1e-3;
      lastGoal = goal;
      farthest = Math.max(farthest, Math.abs(goal - metres));
      assertEquals(24 + 1e3 * metres, centre().x, 1e-9, "frame " + frame);
    }
    assertTrue(farthest > 1e-5, "the device led the tool by " + farthest + " m");
    assertEquals(0, peer.force(device, new Vec3()).length(), 1e-9, "at rest at the end");
  }

  @Test
  void aTurnOfTheDeviceTurnsTheBall() {
    peer.place(device);
    Vec3 first = peer.point(0, new Vec3());
    device.rotation.setRotationVector(new Vec3(0, 0, Math.PI / 2));
    follow(500);
    Vec3 turned = peer.point(0, new Vec3());
    assertEquals(24 - (first.y - 24), turned.x, 0.05);
    assertEquals(24 + (first.x - 24), turned.y, 0.05);
    assertEquals(first.z, turned.z, 0.05);
  }

  @Test
  void theForceOfAPressedBallIsAlongTheNormalAndHoldsItNearTheSurface() {
    peer.place(Pose.at(24, 24, 28));
    device.translation.set(24, 24, TOP + RADIUS_MM - 4);
    follow(600);
    Vec3 force = peer.force(device, new Vec3());
    assertTrue(force.z > 2, "the hand is pushed up by most of the 4 mm: " + force);
    assertTrue(Math.hypot(force.x, force.y) < 0.1 * force.z, "and not sideways: " + force);
    double sunk = TOP + RADIUS_MM - (device.translation.z + force.z);
    assertTrue(sunk > 0 && sunk < 2, "the ball sinks in by " + sunk + " mm");
  }

  @Test
  void aDeeperPressGivesALargerForceAndADeeperBall() {
    double lastForce = 0;
    double lastHeight = Double.POSITIVE_INFINITY;
    peer.place(Pose.at(24, 24, 28));
    for (double depth : new double[] {1, 3, 5, 8}) {
      device.translation.set(24, 24, TOP + RADIUS_MM - depth);
      follow(400);
      double force = peer.force(device, new Vec3()).z;
      double height = device.translation.z + force;
      assertTrue(force > lastForce, depth + " mm deep: " + force);
      assertTrue(height < lastHeight, depth + " mm deep: " + height);
      lastForce = force;
      lastHeight = height;
    }
  }

  /** At rest the spring balances the contacts, each of which this test computes by itself. */
  @Test
  void atRestTheSpringBalancesTheSumOfTheContacts() {
    peer.place(Pose.at(24, 24, 28));
    device.translation.set(24.3, 23.9, TOP + RADIUS_MM - 3);
    follow(4_000);
    Vec3 pull = peer.force(device, new Vec3());
    Vec3 expected = naiveContacts();
    assertTrue(expected.z > 0.5, "N: " + expected);
    assertEquals(0, pull.sub(expected, new Vec3()).length(), 1e-6, "the spring has 1 N/mm");
  }

  /** Returns the contact force as the paper of 1999 describes it, N. */
  private Vec3 naiveContacts() {
    Vec3 middle = centre();
    Vec3 sum = new Vec3();
    int contacts = 0;
    for (int n = 0; n < peer.count(); n++) {
      Vec3 p = peer.point(n, new Vec3());
      int layer = p.z < TOP ? (int) (TOP - Math.floor(p.z)) : 0;
      if (layer > 0) {
        Vec3 inward = middle.sub(p, new Vec3());
        inward.mul(1 / inward.length(), inward);
        Vec3 cell = new Vec3(Math.floor(p.x) + 0.5, Math.floor(p.y) + 0.5, Math.floor(p.z) + 0.5);
        double depth = layer - 1 + Math.max(0, cell.sub(p, cell).dot(inward));
        if (depth > 0) {
          contacts++;
          sum.add(inward.mul(5 * depth, inward), sum);
        }
      }
    }
    return sum.mul(1 / Math.max(1, contacts / 10.0), sum);
  }

  @Test
  void aBallThatIsPlacedAnewForgetsItsMotion() {
    peer.place(Pose.at(24, 24, 40));
    device.translation.set(40, 24, 40);
    follow(20);
    peer.place(Pose.at(10, 10, 40));
    device.translation.set(10, 10, 40);
    peer.follow(device);
    assertEquals(0, peer.force(device, new Vec3()).length(), 1e-12);
  }

  @Test
  void aBallBesideTheGridTouchesNothing() {
    peer.place(Pose.at(-40, 24, 5));
    device.translation.set(-40, 24, 5);
    follow(5);
    assertEquals(0, peer.force(device, new Vec3()).length(), 1e-12);
  }

  /** Returns the layer of each voxel by a search from all empty voxels; 0 in empty space. */
  private static int[] naiveLayers(BitCube bits) {
    int[] layers = new int[EDGE * EDGE * EDGE];
    ArrayDeque<Integer> next = new ArrayDeque<>();
    for (int n = 0; n < layers.length; n++) {
      boolean isSolid = bits.get(n % EDGE, n / EDGE % EDGE, n / (EDGE * EDGE));
      layers[n] = isSolid ? Integer.MAX_VALUE : 0;
      if (!isSolid) {
        next.add(n);
      }
    }
    int[] strides = {1, EDGE, EDGE * EDGE};
    while (!next.isEmpty()) {
      int n = next.remove();
      for (int axis = 0; axis < 3; axis++) {
        int at = n / strides[axis] % EDGE;
        for (int step = -1; step <= 1; step += 2) {
          int beside = n + step * strides[axis];
          boolean isInGrid = at + step >= 0 && at + step < EDGE;
          if (isInGrid && layers[beside] == Integer.MAX_VALUE) {
            layers[beside] = layers[n] + 1;
            next.add(beside);
          }
        }
      }
    }
    return layers;
  }

  /**
   * In the first frame the coupling is at rest, so that contacts alone move the ball: by the force
   * over 0.1 kg times the square of a millisecond. Pushes towards its centre have no torque.
   */
  @Test
  void inTheFirstFrameTheContactsAloneMoveTheBall() {
    SplittableRandom random = new SplittableRandom(20_261_129);
    int touching = 0;
    for (int round = 0; round < 30; round++) {
      BitCube lumps = new BitCube(EDGE, EDGE, EDGE);
      for (int n = 0; n < 40; n++) {
        box(lumps, random.nextInt(40), random.nextInt(40), random.nextInt(40), 8);
      }
      int[] layers = naiveLayers(lumps);
      PenaltyPeer among = new PenaltyPeer(lumps, ball);
      Vec3 centre =
          new Vec3(random.nextDouble(8, 40), random.nextDouble(8, 40), random.nextDouble(8, 40));
      Vec3[] pushes = {new Vec3(), new Vec3()};
      int contacts = 0;
      for (int n = 0; n < ball.count(); n++) {
        contacts += addPush(layers, centre, ball.point(n, new Vec3()), pushes) ? 1 : 0;
      }
      double scale = 1 / Math.max(1, contacts / 10.0);
      Pose expected = Pose.at(centre.x, centre.y, centre.z);
      Vec3 moved = pushes[0].mul(scale / 0.1 * 1e-6 * 1e3, new Vec3());
      double inertia = 0.1 * ball.rmsRadiusMm() * ball.rmsRadiusMm() * 1e-6;
      Vec3 turned = pushes[1].mul(scale * 1e-3 / inertia * 1e-6, new Vec3());
      expected.translation.add(moved, expected.translation);
      expected.rotation.setRotationVector(turned);
      touching += contacts;
      among.place(Pose.at(centre.x, centre.y, centre.z));
      among.follow(Pose.at(centre.x, centre.y, centre.z));
      for (int n = 0; n < ball.count(); n++) {
        Vec3 p = expected.transform(ball.point(n, new Vec3()), new Vec3());
        double off = among.point(n, new Vec3()).sub(p, p).length();
        assertEquals(0, off, 1e-9, "round " + round + " point " + n);
      }
    }
    assertTrue(touching > 3_000, "contacts: " + touching);
  }

  private static void box(BitCube bits, int x, int y, int z, int edge) {
    for (int n = 0; n < edge * edge * edge; n++) {
      bits.set(x + n % edge, y + n / edge % edge, z + n / (edge * edge));
    }
  }

  /** Adds force, N, and torque, N mm, of a point; returns whether it is in contact. */
  private static boolean addPush(int[] layers, Vec3 centre, Vec3 arm, Vec3[] sums) {
    Vec3 p = centre.add(arm, new Vec3());
    int i = (int) Math.floor(p.x);
    int j = (int) Math.floor(p.y);
    int k = (int) Math.floor(p.z);
    int layer = layers[(k * EDGE + j) * EDGE + i];
    Vec3 inward = arm.mul(-1 / arm.length(), new Vec3());
    Vec3 below = new Vec3(i + 0.5, j + 0.5, k + 0.5).sub(p, new Vec3());
    double depth = layer - 1 + Math.max(0, below.dot(inward));
    if (layer == 0 || !(depth > 0)) {
      return false;
    }
    inward.mul(5 * depth, inward);
    sums[0].add(inward, sums[0]);
    sums[1].add(arm.cross(inward, new Vec3()), sums[1]);
    return true;
  }
}
