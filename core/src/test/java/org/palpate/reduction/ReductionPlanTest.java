package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.device.DeviceState;
import org.palpate.device.HandStop;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.MovableShapes;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.phantom.FracturePhantom;

class ReductionPlanTest {
  private static final FracturePhantom PHANTOM = FracturePhantom.parse("fracture:96:4:3");

  private final Fragments fragments = PHANTOM.fragments();
  private final List<Pose> starts = PHANTOM.startPoses(fragments);

  @Test
  void leadsEachFragmentFromWhereItIsToItsPlace() {
    List<HandStop> stops = plan();
    List<Pose> led = new ArrayList<>();
    Pose taken = null;
    for (int n = 1; n < stops.size(); n += stops.get(n).next()) {
      boolean held = stops.get(n).buttons() == DeviceState.FIRST_BUTTON;
      if (held && taken == null) {
        taken = stops.get(n).pose();
        assertTrue(stops.get(n).isSteady(), "takes hold without tremor");
      } else if (!held && taken != null) {
        led.add(motion(taken, stops.get(n).pose()));
        taken = null;
      }
    }
    assertEquals(3, led.size());
    List<Pose> left = new ArrayList<>(starts.subList(1, 4));
    for (Pose way : led) {
      assertTrue(left.removeIf(start -> isInverse(way, start)), "leads nobody home: " + way);
    }
  }

  @Test
  void afterTheLastTryOnAWayTheHandTriesAnotherAndThenPutsAFragmentAside() {
    List<HandStop> stops = plan();
    int asides = 0;
    int others = 0;
    for (int n = 0; n < stops.size(); n++) {
      HandStop home = stops.get(n);
      if (home.aim().isPresent() && home.aim().get().tries() > 0) {
        int next = n + home.aim().get().otherwise();
        int letsGo = n + home.next();
        assertEquals(0, stops.get(letsGo).buttons());
        assertTrue(isInverse(motion(stops.get(letsGo).pose(), home.pose()), new Pose()));
        if (stops.get(next).aim().isPresent()) {
          assertEquals(0, stops.get(next).aim().get().tries(), "looks where it is out");
          others++;
        } else {
          requireAside(stops, home, next, letsGo);
          asides++;
        }
      }
    }
    assertEquals(3, asides);
    assertEquals(6, others);
  }

  private static void requireAside(List<HandStop> stops, HandStop home, int next, int letsGo) {
    int aside = next;
    int after = letsGo + stops.get(letsGo).next();
    while (stops.get(aside).buttons() != 0) {
      aside += stops.get(aside).next();
    }
    assertEquals(after, aside + 5, "both go on alike, the far hand around the bodies");
    for (int n = aside; n <= after; n++) {
      assertEquals(0, stops.get(n).buttons());
      assertEquals(1, stops.get(n).next());
    }
    Vec3 far = stops.get(aside).pose().translation.sub(home.pose().translation, new Vec3());
    assertTrue(far.length() > 80, "is out of the way: " + far);
  }

  /** The fracture left the lid above the hole into which the peg goes. */
  @Test
  void theHandFirstClearsAwayWhatLiesInTheWay() {
    assertEquals(List.of(2, 1, 2), takenWithLidAt(Pose.at(0, 0, 6)));
    assertEquals(List.of(1, 2), takenWithLidAt(Pose.at(0, -40, 0)));
  }

  /** Returns the numbers of the fragments in the order in which the hand takes hold of them. */
  private static List<Integer> takenWithLidAt(Pose lid) {
    List<Body> bodies =
        List.of(
            BlockWithHole.block(),
            BlockWithHole.peg(),
            new Body(
                "lid",
                PullSearchTest.box(6, 6, 12, 10, 10, 16),
                BlockWithHole.GRID,
                Mobility.MOVABLE));
    bodies.get(1).setPose(Pose.at(0, 40, 0));
    bodies.get(2).setPose(lid);
    BodyScene scene = new BodyScene(bodies);
    BodyScene seen = new BodyScene(bodies);
    List<HandStop> stops =
        ReductionPlan.of(
                scene, Collections.nCopies(3, new Pose()), MovableShapes.ofPoints(scene), seen)
            .stops();
    List<Integer> taken = new ArrayList<>();
    for (int n = 1; n < stops.size(); n++) {
      if (stops.get(n).isSteady() && stops.get(n).buttons() > stops.get(n - 1).buttons()) {
        Optional<HandStop.Aim> aim = Optional.empty();
        for (int m = n; aim.isEmpty(); m++) {
          aim = stops.get(m).aim();
        }
        Pose pose = aim.get().seen().get();
        taken.add(bodies.get(1).pose() == pose ? 1 : 2);
      }
    }
    return taken;
  }

  @Test
  void aPointThatLiesInAnotherBodyOnTheWayBlocksIt() {
    Body block = BlockWithHole.block();
    BodyScene scene = new BodyScene(List.of(block));
    Vec3[] inside = {new Vec3(8, 8, 6), new Vec3(8, 8, 6.5)};
    assertEquals(0, new WayOut(scene, -1, inside, 30).blocked());
    Vec3[] caught = {new Vec3(8, 8, 6), new Vec3(1.5, 8, 8)};
    assertTrue(new WayOut(scene, -1, caught, 30).blocked() > 0, "a point is in the block");
  }

  /** Returns the motion that leads a held body from one pose of the hand to another. */
  private static Pose motion(Pose from, Pose to) {
    Pose motion = new Pose();
    to.rotation.multiply(from.rotation.conjugate(new Quaternion()), motion.rotation);
    Vec3 turned = motion.rotation.rotate(from.translation, new Vec3());
    to.translation.sub(turned, motion.translation);
    return motion;
  }

  private static boolean isInverse(Pose way, Pose start) {
    Pose back = way.multiply(start, new Pose());
    return back.translation.length() < 1e-9 && back.rotation.angle() < 1e-9;
  }

  @Test
  void theFreeHandTouchesOnlyTheFragmentThatItPresses() {
    List<HandStop> stops = plan();
    BodyScene scene = scene();
    FreeLines lines = new FreeLines(scene);
    int presses = 0;
    for (int n = 1; n < stops.size(); n++) {
      HandStop from = stops.get(n - 1);
      HandStop to = stops.get(n);
      if (from.buttons() == 0 && to.buttons() == 0 && presses == 0) {
        boolean isPress = stops.get(n + 1).buttons() != 0;
        Vec3 end = to.pose().translation;
        assertEquals(!isPress, lines.isFree(from.pose().translation, end), "stop " + n);
        presses += isPress ? 1 : 0;
      }
    }
    assertEquals(1, presses);
  }

  @Test
  void anInterruptEndsThePlan() {
    Thread.currentThread().interrupt();
    try {
      assertThrows(CancellationException.class, this::plan);
    } finally {
      assertTrue(Thread.interrupted(), "the thread stays interrupted");
    }
  }

  @Test
  void theFirstApproachLeadsStraightToAFragmentAndNothingIsTouchedBefore() {
    BodyScene scene = scene();
    ReductionPlan plan = plan(scene());
    List<HandStop> stops = plan.stops();
    int first = plan.firstApproach();
    assertTrue(first > 0, "it goes around the bone first");
    FreeLines lines = new FreeLines(scene);
    for (int n = 0; n < first; n++) {
      assertEquals(0, stops.get(n).buttons(), "stop " + n);
      assertTrue(
          lines.isFree(stops.get(n).pose().translation, stops.get(n + 1).pose().translation),
          "stop " + n);
    }
    Vec3 far = stops.get(first).pose().translation;
    assertFalse(lines.isFree(far, stops.get(first + 1).pose().translation), "presses a fragment");
    assertEquals(0, stops.get(first + 1).buttons());
    assertEquals(DeviceState.FIRST_BUTTON, stops.get(first + 2).buttons(), "and takes hold of it");
  }

  @Test
  void theWidestWayLeadsOutOfAHole() {
    Body block = BlockWithHole.block();
    FreeLines lines = new FreeLines(new BodyScene(List.of(block)));
    Vec3[] points = {new Vec3(8, 8, 6), new Vec3(8.5, 8.5, 7)};
    Vec3 way = new WayOut(new BodyScene(List.of(block)), -1, points, 30).direction();
    assertTrue(way.z > 0.95, "the hole opens upwards: " + way);
    assertTrue(lines.isFree(points[0], new Vec3(8, 8, 40)));
    assertFalse(lines.isFree(points[0], new Vec3(40, 8, 6)));
  }

  private List<HandStop> plan() {
    return plan(scene()).stops();
  }

  private ReductionPlan plan(BodyScene scene) {
    List<Pose> truth = Collections.nCopies(4, new Pose());
    return ReductionPlan.of(scene, truth, MovableShapes.ofPoints(scene), scene());
  }

  private BodyScene scene() {
    List<Body> bodies = new ArrayList<>();
    for (int n = 0; n < 4; n++) {
      Mobility mobility = n == 0 ? Mobility.FIXED : Mobility.MOVABLE;
      Body body = new Body("f" + n, fragments.bits().get(n), fragments.grid(), mobility);
      body.setPose(starts.get(n));
      bodies.add(body);
    }
    return new BodyScene(bodies);
  }
}
