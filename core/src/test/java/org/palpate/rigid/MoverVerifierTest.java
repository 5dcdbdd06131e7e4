package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.Mover.EditOutcome;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

class MoverVerifierTest {
  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final Quaternion scratch = new Quaternion();
  private int freeCount;
  private int blockedCount;

  @Test
  void answersLikeACastOfEveryLegOverChainsOfHostileMotions() {
    for (int round = 0; round < 40; round++) {
      BodyScene scene = ToolScenes.clutter(random, 1 + round % 3);
      RigidTool tool = ToolScenes.tool(random);
      runChain(scene, tool, clearances(scene, tool, round % 2 == 0), 150);
    }
    assertTrue(freeCount > 300 && blockedCount > 300, freeCount + " free, " + blockedCount);
  }

  private static Clearance[] clearances(BodyScene scene, RigidTool tool, boolean pointsOnly) {
    Clearance[] result = new Clearance[scene.count()];
    for (int b = 0; b < result.length; b++) {
      result[b] =
          pointsOnly || !ToolScenes.hasCoveredSurface(tool)
              ? Clearance.POINTS
              : Clearance.ofWholeBody(tool, scene.body(b).grid(), 0);
    }
    return result;
  }

  private static void continueEnclosureCheck(MoverVerifier verifier) {
    EnclosureCheck enclosure = verifier.pair(0).enclosure();
    if (enclosure.canContinue()) {
      enclosure.continueCheck();
    }
  }

  private void runChain(BodyScene scene, RigidTool tool, Clearance[] clearances, int steps) {
    MoverVerifier quick = ToolScenes.verifier(scene, tool, clearances, true);
    MoverVerifier slow = ToolScenes.verifier(scene, tool, clearances, false);
    NaiveVerifier naive = new NaiveVerifier(scene, tool);
    Pose start = RandomGeometry.pose(random, 30);
    while (!quick.place(start, false)) {
      start = RandomGeometry.pose(random, 60);
    }
    assertTrue(slow.place(start, false));
    Pose before = new Pose().set(start);
    for (int step = 0; step < steps; step++) {
      suggestNormals(quick, scene);
      Pose candidate = candidate(quick.pose(), scene, step);
      boolean free = check(quick, slow, naive, candidate);
      if (free) {
        before.set(quick.pose());
        quick.commit();
        slow.commit();
        assertNull(naive.fault(before, quick.pose()));
        if (random.nextInt(5) == 0) { // and back, as a frame that is taken back
          quick.takeBack(before);
          slow.takeBack(before);
        }
        quick.raiseLevels(20);
        slow.raiseLevels(20);
        assertEquals(slow.reducedCount(), quick.reducedCount());
      }
      freeCount += free ? 1 : 0;
      blockedCount += free ? 0 : 1;
    }
  }

  /** Suggests normals as contacts do, of which some are along an axis. */
  private void suggestNormals(MoverVerifier verifier, BodyScene scene) {
    for (int b = 0; b < scene.count(); b++) {
      Vec3 normal = RandomGeometry.vector(random, 1);
      if (random.nextBoolean()) {
        normal.set(0, 0, 0);
        normal.set(random.nextInt(3), random.nextBoolean() ? 1 : -1);
      }
      verifier.pair(b).heights.suggest(normal.mul(1 / normal.length(), normal));
    }
  }

  private boolean check(
      MoverVerifier quick, MoverVerifier slow, NaiveVerifier naive, Pose candidate) {
    LegHits quickHits = new LegHits();
    LegHits slowHits = new LegHits();
    quick.propose(candidate);
    slow.propose(candidate);
    boolean firstOnly = random.nextBoolean();
    boolean free = quick.isFree(0, 0, firstOnly, quickHits);
    assertEquals(slow.isFree(0, 0, firstOnly, slowHits), free);
    assertEquals(naive.isFreeOfLevels(quick.pose(), candidate, quick), free);
    assertEquals(slowHits.count(), quickHits.count());
    assertTrue(Arrays.equals(slowHits.point, quickHits.point));
    assertTrue(Arrays.equals(slowHits.t, quickHits.t));
    assertEquals(slow.tested(), quick.tested(), "work is counted as if nothing were left out");
    return free;
  }

  /** Moves of all sizes, along grid axes, onto voxel faces, far away and back. */
  private Pose candidate(Pose from, BodyScene scene, int step) {
    double size = Math.pow(10, random.nextDouble(-7, 1.3));
    Vec3 displacement = RandomGeometry.vector(random, size);
    Vec3 rotation = RandomGeometry.vector(random, 0.1 * size);
    Pose pose = from.displace(displacement, rotation, 1, scratch, new Pose());
    switch (random.nextInt(11)) {
      case 0 -> pose.rotation.set(from.rotation);
      case 1 -> pose.translation.set(Math.rint(pose.translation.x), 3, pose.translation.z);
      case 2 -> pose.set(from);
      case 3 -> pose.translation.set(step % 3, Math.rint(2 * pose.translation.get(step % 3)) / 2);
      case 4 -> pose.rotation.setIdentity();
      case 5, 6, 7, 8 -> pullTowards(pose, from, scene.body(random.nextInt(scene.count())));
      default -> {}
    }
    if (random.nextInt(40) == 0) {
      pose.translation.set(random.nextInt(3), random.nextBoolean() ? 1e9 : -1e7);
    } else if (Math.abs(from.translation.x + from.translation.y + from.translation.z) > 1e5) {
      pose.set(RandomGeometry.pose(random, 60));
    }
    return pose;
  }

  /** Moves towards a random solid voxel. */
  private void pullTowards(Pose pose, Pose from, Body body) {
    Vec3 goal = new Vec3();
    do {
      goal.set(
          random.nextInt(body.grid().sizeX()),
          random.nextInt(body.grid().sizeY()),
          random.nextInt(body.grid().sizeZ()));
    } while (!body.bits().get((int) goal.x, (int) goal.y, (int) goal.z));
    body.pose().transform(body.grid().gridToWorld(goal, goal), goal);
    goal.sub(from.translation, goal).mul(random.nextDouble(0.05, 0.8), goal);
    pose.translation.set(goal.add(from.translation, goal));
  }

  @Test
  void largeTurnsCountAsFreeOnlyIfTheArcsAreFreeToo() {
    BitCube bits = new BitCube(60, 60, 60);
    bits.set(17, 41, 30);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("dot", bits)));
    RigidTool tool = ToolSampler.ofShape(new BoxShape(30, 1, 1), 0.7);
    MoverVerifier verifier =
        ToolScenes.verifier(scene, tool, new Clearance[] {Clearance.POINTS}, true);
    Pose start = new Pose();
    start.translation.set(17, 27, 30.5); // its end swings past the dot
    Pose end = new Pose().set(start);
    end.rotation.setRotationVector(new Vec3(0, 0, 3));
    assertTrue(verifier.place(start, true));
    verifier.propose(end);
    assertTrue(verifier.isFree(0, 0, true, new LegHits()), "the chords are free");
    assertFalse(verifier.isFree(0, 3, true, new LegHits()), "but not known to be free as arcs");
    start.translation.set(-200, 0, 0);
    end.translation.set(-205, 0, 0);
    assertTrue(verifier.place(start, true));
    verifier.propose(end);
    assertTrue(verifier.isFree(0, 3, true, new LegHits()), "far away they are");
  }

  @Test
  void editsAreSeenAtOnceByPointsThatRestOnEmptySpace() {
    for (int round = 0; round < 30; round++) {
      BitCube bits = new BitCube(40, 40, 40);
      bits.set(39, 39, 39);
      Body body = ToolScenes.unit("edited", bits);
      BodyScene scene = new BodyScene(List.of(body));
      RigidTool tool = ToolSampler.ofShape(RodShape.sphere(4), 0.7);
      Clearance[] clearances = clearances(scene, tool, round % 2 == 0);
      MoverVerifier verifier = ToolScenes.verifier(scene, tool, clearances, true);
      NaiveVerifier naive = new NaiveVerifier(scene, tool);
      Pose pose = new Pose();
      pose.translation.set(20.25, 20.4, 20.3);
      assertTrue(verifier.place(pose, true));
      verifier.propose(pose);
      assertTrue(verifier.isFree(0, 0, true, new LegHits())); // now all points rest
      IntBox box = new IntBox();
      for (int n = 0; n < 3; n++) {
        int i = random.nextInt(12, 29);
        int j = random.nextInt(12, 29);
        int k = random.nextInt(12, 29);
        Vec3 centre = new Vec3(i + 0.5, j + 0.5, k + 0.5);
        if (centre.sub(pose.translation, centre).length() > 4) { // the tool does not enclose it
          bits.set(i, j, k);
          box.include(i, j, k);
        }
      }
      body.voxelsChanged(box);
      boolean free = naive.fault(pose, pose) == null;
      assertEquals(free ? EditOutcome.FREE : EditOutcome.COLLIDING, verifier.takeEdits());
      Pose moved =
          pose.displace(RandomGeometry.vector(random, 1), new Vec3(), 1, scratch, new Pose());
      verifier.propose(moved);
      if (free) {
        boolean expected = naive.isFreeOfLevels(pose, moved, verifier);
        assertEquals(expected, verifier.isFree(0, 0, true, new LegHits()));
      }
    }
  }

  @Test
  void anEditInsideTheToolIsSeenAlthoughItTouchesNoPoint() {
    BitCube bits = new BitCube(40, 40, 40);
    bits.set(39, 39, 39);
    Body body = ToolScenes.unit("edited", bits);
    BodyScene scene = new BodyScene(List.of(body));
    RigidTool tool = ToolSampler.ofShape(RodShape.sphere(8), 0.7);
    for (int mode = 0; mode < 2; mode++) {
      MoverVerifier verifier =
          ToolScenes.verifier(scene, tool, clearances(scene, tool, mode == 0), true);
      Pose pose = new Pose();
      pose.translation.set(20, 20, 20);
      assertTrue(verifier.place(pose, true));
      IntBox box = new IntBox();
      box.include(21, 19, 20);
      bits.set(21, 19, 20);
      body.voxelsChanged(box);
      assertEquals(
          mode == 0 ? EditOutcome.FREE : EditOutcome.COLLIDING,
          verifier.takeEdits(),
          "mode " + mode);
      bits.clear(21, 19, 20);
      body.voxelsChanged(box);
      assertEquals(EditOutcome.FREE, verifier.takeEdits());
    }
  }

  @Test
  void aSolidThatPassedBetweenReducedPointsIsFoundInsideTheTool() {
    BitCube bits = new BitCube(3, 3, 3);
    bits.set(1, 1, 1);
    VoxelGrid fine =
        new VoxelGrid(
            3, 3, 3, new Vec3(0.1, 0.1, 0.1), VoxelGrid.ofUnitVoxels(3, 3, 3).gridMmToWorld());
    Body dot = new Body("dot", bits, fine, Mobility.FIXED);
    BodyScene scene = new BodyScene(List.of(dot));
    BitCube cube = ToolScenes.block(8, 8, 8);
    RigidTool tool = ToolSampler.ofSegment(cube, VoxelGrid.ofUnitVoxels(8, 8, 8));
    Clearance[] clearance = {Clearance.ofWholeBody(tool, fine, 0)};
    MoverVerifier verifier = ToolScenes.verifier(scene, tool, clearance, true);
    Pose pose = new Pose();
    pose.translation.set(0.15, 0.15, 4.3); // the dot is 0.1 below the middle of four points
    assertFalse(verifier.place(pose, true));
    assertTrue(verifier.place(pose, false));
    assertEquals(4, verifier.reducedCount());
    assertTrue(goTo(verifier, 2.0), "the dot passes between the points");
    verifier.raiseLevels(tool.count());
    verifier.raiseLevels(tool.count());
    for (int frame = 0; frame < 200; frame++) {
      continueEnclosureCheck(verifier);
      assertEquals(1, verifier.reducedCount(), "the tool encloses the dot");
    }
    verifier.place(pose, false);
    assertTrue(goTo(verifier, 7));
    verifier.raiseLevels(tool.count());
    verifier.raiseLevels(tool.count());
    continueEnclosureCheck(verifier);
    assertEquals(0, verifier.reducedCount(), "the tool encloses nothing");
  }

  @Test
  void aPointThatStartsNearerThanTheClearanceNeverComesNearerAndKeepsWhatItGains() {
    BitCube bits = new BitCube(30, 30, 30);
    for (int n = 0; n < 900; n++) {
      bits.set(n % 30, n / 30, 9);
    }
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("slab", bits)));
    RigidTool tool = ToolSampler.point();
    Clearance clearance = new Clearance(1, 0.5, 2); // half a voxel, then a whole one
    MoverVerifier verifier = ToolScenes.verifier(scene, tool, new Clearance[] {clearance}, true);
    Pose pose = new Pose();
    pose.translation.set(15, 15, 10.2);
    assertFalse(verifier.place(pose, true));
    assertTrue(verifier.place(pose, false));
    assertEquals(1, verifier.reducedCount());
    assertTrue(goTo(verifier, 10.01), "level 0: no solid voxel is touched");
    assertTrue(goTo(verifier, 10.6));
    verifier.raiseLevels(10);
    assertEquals(1, verifier.pair(0).level(0));
    assertFalse(goTo(verifier, 10.49));
    assertTrue(goTo(verifier, 11.1));
    verifier.raiseLevels(10);
    assertEquals(1, verifier.reducedCount(), "it is not known yet that the tool encloses nothing");
    for (int frame = 0; frame < 10; frame++) {
      continueEnclosureCheck(verifier);
    }
    assertEquals(0, verifier.reducedCount());
    assertFalse(goTo(verifier, 10.99));
  }

  @Test
  void aPlaceThatWasFilledSinceTheLastFrameIsNotFree() {
    BitCube bits = new BitCube(30, 30, 30);
    Body body = ToolScenes.unit("filled", bits);
    Clearance[] clearance = {new Clearance(1, 0.5, 2)};
    BodyScene scene = new BodyScene(List.of(body));
    MoverVerifier verifier = ToolScenes.verifier(scene, ToolSampler.point(), clearance, true);
    Pose pose = new Pose();
    pose.translation.set(15.5, 15.5, 15.5);
    assertTrue(verifier.place(pose, true));
    bits.set(15, 15, 15);
    IntBox filled = new IntBox();
    filled.include(15, 15, 15);
    body.voxelsChanged(filled);
    assertFalse(verifier.place(pose, false));
  }

  private static boolean goTo(MoverVerifier verifier, double z) {
    Pose pose = new Pose().set(verifier.pose());
    pose.translation.z = z;
    verifier.propose(pose);
    boolean free = verifier.isFree(0, 0, true, new LegHits());
    if (free) {
      verifier.commit();
    }
    return free;
  }

  @Test
  void aHitNamesTheFaceAndTheDistanceFromIt() {
    BitCube bits = new BitCube(10, 10, 10);
    bits.set(5, 5, 5);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("dot", bits)));
    RigidTool tool = ToolSampler.point();
    MoverVerifier verifier =
        ToolScenes.verifier(scene, tool, new Clearance[] {Clearance.POINTS}, true);
    Pose pose = new Pose();
    pose.translation.set(5.5, 7.25, 5.5);
    assertTrue(verifier.place(pose, true));
    pose.translation.y = 5.5;
    verifier.propose(pose);
    LegHits hits = new LegHits();
    assertFalse(verifier.isFree(0, 0, false, hits));
    assertEquals(1, hits.count());
    assertEquals(1, hits.axis[0]);
    assertEquals(1, hits.side[0]);
    assertEquals(1.25, hits.gapMm[0]);
  }

  @Test
  void theNaiveVerifierCatchesALegThatIsOffByTheLastBit() {
    BitCube bits = new BitCube(4, 4, 4);
    bits.set(2, 2, 2);
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("dot", bits)));
    NaiveVerifier naive = new NaiveVerifier(scene, ToolSampler.point());
    Pose a = new Pose();
    Pose b = new Pose();
    a.translation.set(Math.nextDown(2.0), 0.5, 2.5);
    b.translation.set(Math.nextDown(2.0), 3.5, 2.5);
    assertNull(naive.fault(a, b));
    a.translation.x = 2;
    b.translation.x = 2;
    assertNotNull(naive.fault(a, b));
  }
}
