package org.palpate.benchmarks.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.collision.CollisionScene;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.testing.LegJudge;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

class PointShellTest {
  private static final GridMetric SPACING = new GridMetric(1, 0.5, 2);
  private static final int POINTS = 150;
  private static final int FRAMES = 60;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final BitCube bits = ball();
  private final CollisionScene scene = new CollisionScene(List.of(bits));
  private final double[] tool = toolMm();
  private final PointShell shell = new PointShell(tool);
  private final Vec3[] axes = {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};
  private final Vec3 origin = new Vec3(5, 5, 60);
  private final RigidTransform pose = new RigidTransform(axes[0], axes[1], axes[2], origin);

  private static BitCube ball() {
    BitCube cube = new BitCube(40, 80, 20);
    for (int k = 0; k < 20; k++) {
      for (int j = 0; j < 80; j++) {
        for (int i = 0; i < 40; i++) {
          if (Math.hypot(Math.hypot(i - 20, (j - 40) * 0.5), (k - 10) * 2) < 14) {
            cube.set(i, j, k);
          }
        }
      }
    }
    return cube;
  }

  private double[] toolMm() {
    double[] mm = new double[3 * POINTS];
    for (int n = 0; n < mm.length; n++) {
      mm[n] = random.nextDouble(-6, 6);
    }
    return mm;
  }

  /** Turns about a changing axis and moves towards the far side of the ball. */
  private void move(int frame) {
    double angle = 0.03 * frame;
    axes[0].set(Math.cos(angle), Math.sin(angle), 0);
    axes[1].set(-Math.sin(angle), Math.cos(angle), 0);
    origin.set(5 + 0.4 * frame, 5 + 0.3 * frame, 60 - frame);
  }

  @Test
  void contactsAndHitsEqualTheCastsOfSinglePoints() {
    ShellContacts contacts = new ShellContacts(POINTS);
    ShellCollider collider = new ShellCollider();
    shell.place(pose, SPACING);
    int all = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      Vec3[] before = naivePositions();
      move(frame);
      shell.place(pose, SPACING);
      int count = collider.cast(scene, shell, 0, POINTS, contacts);
      assertEquals(count, contacts.count());
      assertHits(before, naivePositions(), contacts, "seed=" + Seeds.seed() + " frame=" + frame);
      all += count;
    }
    assertTrue(all > 200, "too few contacts to mean anything: " + all);
  }

  private void assertHits(Vec3[] before, Vec3[] now, ShellContacts contacts, String what) {
    RayHit expected = new RayHit();
    RayHit hit = new RayHit();
    for (int point = 0; point < POINTS; point++) {
      Vec3 from = before[point];
      Vec3 to = now[point];
      Ray ray = new Ray().from(from.x, from.y, from.z).to(to.x, to.y, to.z);
      boolean touches = new ExactRayCaster().cast(bits, ray, expected);
      assertEquals(touches, contacts.isContact(point), what + " point=" + point);
      if (touches) {
        contacts.hit(point, hit);
        assertEquals(expected.t, hit.t, what);
        assertTrue(hit.i == expected.i && hit.j == expected.j && hit.k == expected.k, what);
        assertEquals(expected.axis, hit.axis, what);
      }
    }
  }

  /** Transforms each point by the transform's own method, in new vectors. */
  private Vec3[] naivePositions() {
    Vec3[] positions = new Vec3[POINTS];
    for (int point = 0; point < POINTS; point++) {
      Vec3 mm = new Vec3(tool[3 * point], tool[3 * point + 1], tool[3 * point + 2]);
      pose.transform(mm, mm);
      positions[point] = mm.set(mm.x / 1, mm.y / 0.5, mm.z / 2);
    }
    return positions;
  }

  @Test
  void everyInteractionPointMovesAsASinglePoint() {
    ShellResponse response =
        new ShellResponse(POINTS, SPACING, () -> new GuardedSolver(SPACING, 8));
    shell.place(pose, SPACING);
    response.place(scene, shell);
    GuardedSolver[] solvers = new GuardedSolver[POINTS];
    InteractionPoint[] expected = new InteractionPoint[POINTS];
    LegJudge[] judges = new LegJudge[POINTS];
    for (int point = 0; point < POINTS; point++) {
      solvers[point] = new GuardedSolver(SPACING, 8);
      expected[point] = new InteractionPoint();
      expected[point].position.set(response.point(point).position);
      judges[point] = new LegJudge(bits, expected[point].position);
    }
    int contacts = 0;
    for (int frame = 0; frame < FRAMES; frame++) {
      move(frame);
      shell.place(pose, SPACING);
      contacts += response.follow(scene, shell, 0, POINTS);
      Vec3[] devices = naivePositions();
      for (int point = 0; point < POINTS; point++) {
        solvers[point].follow(scene, devices[point], expected[point]);
        assertTrue(response.point(point).position.sameBits(expected[point].position));
        assertEquals(expected[point].contact, response.point(point).contact);
        assertNull(judges[point].faultOf(response.point(point)));
      }
    }
    assertTrue(contacts > 1_000, "too few contacts to mean anything: " + contacts);
  }

  @Test
  void aPointPlacedInASolidIsSetFree() {
    ShellResponse response =
        new ShellResponse(POINTS, SPACING, () -> new GuardedSolver(SPACING, 8));
    origin.set(20, 20, 20);
    shell.place(pose, SPACING);
    response.place(scene, shell);
    for (int point = 0; point < POINTS; point++) {
      Vec3 p = response.point(point).position;
      assertFalse(scene.touches(p.x, p.y, p.z));
    }
  }

  @Test
  void framesAllocateNothing() {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    ShellContacts contacts = new ShellContacts(POINTS);
    ShellCollider collider = new ShellCollider();
    ShellResponse response =
        new ShellResponse(POINTS, SPACING, () -> new GuardedSolver(SPACING, 8));
    shell.place(pose, SPACING);
    response.place(scene, shell);
    long least = Long.MAX_VALUE;
    for (int round = 0; round < 8; round++) { // the JVM itself allocates a little while it compiles
      long before = threads.getCurrentThreadAllocatedBytes();
      for (int frame = 0; frame < 400; frame++) {
        move(frame % FRAMES);
        shell.place(pose, SPACING);
        collider.cast(scene, shell, 0, POINTS, contacts);
        response.follow(scene, shell, 0, POINTS);
      }
      least = Math.min(least, threads.getCurrentThreadAllocatedBytes() - before);
    }
    assertEquals(0, least);
  }

  @Test
  void refusesPointsWithoutThreeDoublesEach() {
    assertThrows(IllegalArgumentException.class, () -> new PointShell(new double[4]));
    assertThrows(IllegalArgumentException.class, () -> new PointShell(new double[0]));
  }
}
