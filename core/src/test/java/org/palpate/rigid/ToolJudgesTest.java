package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/** The judges of a rigid tool find motions and overlaps that are planted. */
class ToolJudgesTest {
  private final RigidTool point = ToolSampler.point();
  private final BodyScene scene = new BodyScene(List.of(dot()));
  private final ToolLegJudge judge = new ToolLegJudge(scene, point);
  private final ToolMotion motion = new ToolMotion(1);

  /** Returns a body of one voxel from (3,3,3) to (4,4,4). */
  private static Body dot() {
    BitCube bits = new BitCube(7, 7, 7);
    bits.set(3, 3, 3);
    return new Body("dot", bits, VoxelGrid.ofUnitVoxels(7, 7, 7), Mobility.FIXED);
  }

  /** Sets the path of the next frame. */
  private void path(Pose... poses) {
    motion.placeAt(poses[0]);
    motion.freed = false;
    for (int n = 1; n < poses.length; n++) {
      motion.add(poses[n], 1);
    }
  }

  @Test
  void aChainOfStepsBesideTheVoxelIsFree() {
    path(Pose.at(0, 0, 0));
    assertNull(judge.begin(motion));
    path(Pose.at(0, 0, 0), Pose.at(2, 0, 0), Pose.at(2, 5, 0));
    assertNull(judge.fault(motion));
    path(Pose.at(2, 5, 0));
    assertNull(judge.fault(motion));
    assertEquals(3, judge.legs(), "one at the begin and two steps");
  }

  @Test
  void aToolThatBeginsInAVoxelIsFound() {
    path(Pose.at(3.5, 3.5, 4));
    assertNotNull(judge.begin(motion), "on its face");
    path(Pose.at(3.5, 3.5, Math.nextUp(4.0)));
    assertNull(judge.begin(motion));
    path(Pose.at(0, 0, 0), Pose.at(3.5, 3.5, 3.5));
    assertNull(judge.beginOfFrame(motion), "the frame began outside");
    assertNotNull(judge.begin(motion), "and ended inside");
  }

  @Test
  void theStepThatTouchesIsNamed() {
    path(Pose.at(0, 0, 0));
    judge.begin(motion);
    path(Pose.at(0, 0, 0), Pose.at(0, 3.5, 3.5), Pose.at(9, 3.5, 3.5));
    String fault = judge.fault(motion);
    assertTrue(fault.startsWith("step 1 of 2: body 0 point 0"), fault);
  }

  @Test
  void aFrameThatStartsElsewhereIsFound() {
    path(Pose.at(0, 0, 0));
    judge.begin(motion);
    path(Pose.at(Double.MIN_VALUE, 0, 0), Pose.at(2, 0, 0));
    assertTrue(judge.fault(motion).startsWith("frame starts at"));
    path(Pose.at(0, 0, 0), Pose.at(2, 0, 0));
    assertNull(judge.fault(motion));
    path(Pose.at(0, 0, 0), Pose.at(1, 0, 0));
    assertTrue(judge.fault(motion).startsWith("frame starts at"), "the last one ended at 2");
  }

  @Test
  void aToolThatIsSetFreeBeginsANewChainAndMustBeFree() {
    path(Pose.at(0, 0, 0));
    judge.begin(motion);
    path(Pose.at(6, 6, 6));
    motion.freed = true;
    assertNull(judge.fault(motion));
    path(Pose.at(6, 6, 6), Pose.at(6, 6, 5));
    assertNull(judge.fault(motion));
    path(Pose.at(3.5, 3.5, 3.5));
    motion.freed = true;
    assertTrue(judge.fault(motion).startsWith("set free in a solid"));
  }

  private static Pose randomPose(SplittableRandom random) {
    Pose pose = Pose.at(random.nextDouble(2, 5), random.nextDouble(2, 5), random.nextDouble(2, 5));
    pose.rotation.setRotationVector(
        new Vec3(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-2, 2)));
    return pose;
  }

  /** A common point proves an overlap; a box that overlaps has one if it is a little larger. */
  @Test
  void aBoxOverlapsTheVoxelExactlyIfTheyShareAPoint() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    BoxShape box = new BoxShape(1.5, 2.5, 0.8);
    int overlapping = 0;
    int apart = 0;
    for (int n = 0; n < 400; n++) {
      Pose pose = randomPose(random);
      boolean overlaps = new OverlapJudge(box).overlaps(scene, pose);
      boolean shares = sharesAPoint(box, pose);
      assertTrue(overlaps || !shares, "a common point at pose " + pose);
      overlapping += overlaps ? 1 : 0;
      apart += overlaps ? 0 : 1;
      if (overlaps) {
        assertTrue(shares || sharesAPoint(grown(box, 0.12), pose), "no common point at " + pose);
      }
    }
    assertTrue(overlapping > 30 && apart > 100, overlapping + " " + apart);
  }

  private static BoxShape grown(BoxShape box, double by) {
    return new BoxShape(box.edgeX() + by, box.edgeY() + by, box.edgeZ() + by);
  }

  /** Looks for a common point on a lattice of 25 points along each edge of the box. */
  private static boolean sharesAPoint(BoxShape box, Pose pose) {
    Vec3 p = new Vec3();
    for (int n = 0; n < 25 * 25 * 25; n++) {
      p.set(
          box.edgeX() * (n % 25 / 24.0 - 0.5),
          box.edgeY() * (n / 25 % 25 / 24.0 - 0.5),
          box.edgeZ() * (n / 625 % 25 / 24.0 - 0.5));
      pose.transform(p, p);
      if (isInside(p.x) && isInside(p.y) && isInside(p.z)) {
        return true;
      }
    }
    return false;
  }

  private static boolean isInside(double coordinate) {
    return coordinate > 3 && coordinate < 4;
  }

  @Test
  void facesThatTouchDoNotOverlapAndTheGapIsTheirDistance() {
    OverlapJudge cubes = new OverlapJudge(new BoxShape(2, 2, 2));
    assertFalse(cubes.overlaps(scene, Pose.at(5, 3.5, 3.5)), "its face is the plane x = 4");
    assertEquals(0, cubes.leastGapMm(), 1e-12);
    assertTrue(cubes.overlaps(scene, Pose.at(5 - 1e-6, 3.5, 3.5)));
    assertEquals(-1e-6, cubes.leastGapMm(), 1e-12);
    OverlapJudge away = new OverlapJudge(new BoxShape(2, 2, 2));
    assertFalse(away.overlaps(scene, Pose.at(3.5, 3.5, 1.75)));
    assertEquals(0.25, away.leastGapMm(), 1e-12);
  }

  @Test
  void aBoxOnItsEdgeIsAsWideAsItsDiagonal() {
    Pose turned = Pose.at(3.5, 3.5, 4 + Math.sqrt(2));
    turned.rotation.setRotationVector(new Vec3(Math.PI / 4, 0, 0));
    OverlapJudge edge = new OverlapJudge(new BoxShape(2, 2, 2));
    turned.translation.z += 1e-6;
    assertFalse(edge.overlaps(scene, turned));
    turned.translation.z -= 2e-6;
    assertTrue(edge.overlaps(scene, turned));
  }

  @Test
  void aToolOfVoxelsOverlapsWithAnyOfThem() {
    BitCube bits = new BitCube(4, 1, 1);
    bits.set(0, 0, 0);
    bits.set(3, 0, 0);
    RigidTool tool = ToolSampler.ofSegment(bits, VoxelGrid.ofUnitVoxels(4, 1, 1));
    OverlapJudge two = new OverlapJudge(bits, tool);
    // The reference point is the middle of both voxels: they lie from 1 to 2 beside it.
    assertTrue(two.overlaps(scene, Pose.at(3.5 - 1.5, 3.5, 3.5)));
    assertTrue(two.overlaps(scene, Pose.at(3.5 + 1.5, 3.5, 3.5)));
    assertFalse(two.overlaps(scene, Pose.at(3.5, 3.5, 3.5)), "the voxel fits between them");
    assertFalse(two.overlaps(scene, Pose.at(3.5, 4.5, 3.5)));
  }

  @Test
  void anyBodyOfASceneCanOverlap() {
    Body second = dot();
    second.setPose(Pose.at(20, 0, 0));
    BodyScene both = new BodyScene(List.of(dot(), second));
    OverlapJudge cube = new OverlapJudge(new BoxShape(1, 1, 1));
    assertTrue(cube.overlaps(both, Pose.at(3.2, 3.2, 3.2)));
    assertTrue(cube.overlaps(both, Pose.at(23.2, 3.2, 3.2)));
    assertFalse(cube.overlaps(both, Pose.at(13.2, 3.2, 3.2)));
  }

  /**
   * A tool of flat voxels among flat voxels of other edges, both turned. A common point proves an
   * overlap; a gap is never wider than the distance of two points.
   */
  @Test
  void toolsOfVoxelsOfAnyEdgesOverlapWhereTheySharePoints() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    Vec3 bodyEdges = new Vec3(1, 1.7, 0.6);
    VoxelGrid bodyGrid = VoxelGrid.ofFirstCentre(5, 4, 6, bodyEdges, turned(0.3));
    int overlapping = 0;
    int apart = 0;
    for (int n = 0; n < 150; n++) {
      BitCube solid = new BitCube(5, 4, 6);
      solid.set(random.nextInt(5), random.nextInt(4), random.nextInt(6));
      solid.set(random.nextInt(5), random.nextInt(4), random.nextInt(6));
      Body body = new Body("body", solid, bodyGrid, Mobility.MOVABLE);
      body.setPose(randomPose(random));
      BitCube bits = new BitCube(3, 4, 2);
      bits.set(random.nextInt(3), random.nextInt(4), random.nextInt(2));
      bits.set(random.nextInt(3), random.nextInt(4), random.nextInt(2));
      VoxelGrid grid = VoxelGrid.ofFirstCentre(3, 4, 2, new Vec3(0.7, 1.1, 2.3), turned(-0.7));
      RigidTool tool = ToolSampler.ofSegment(bits, grid);
      Pose pose = randomPose(random);
      BodyScene one = new BodyScene(List.of(body));
      OverlapJudge overlap = new OverlapJudge(bits, grid, tool);
      boolean overlaps = overlap.overlaps(one, pose);
      List<Vec3> ofTool = toolPoints(bits, grid, tool, pose);
      boolean shares = ofTool.stream().anyMatch(p -> isSolid(body, p));
      assertTrue(overlaps || !shares, "seed " + Seeds.seed() + " n=" + n);
      double distance = distance(ofTool, bodyPoints(body));
      if (!overlaps) {
        double gap = overlap.leastGapMm();
        assertTrue(gap <= distance + 1e-9 || distance > 0.5, "seed " + Seeds.seed() + " n=" + n);
      } else {
        assertTrue(distance < 0.5, "seed " + Seeds.seed() + " n=" + n + ": " + distance);
      }
      overlapping += overlaps ? 1 : 0;
      apart += overlaps ? 0 : 1;
    }
    assertTrue(overlapping > 10 && apart > 40, overlapping + " " + apart);
  }

  private static RigidTransform turned(double radians) {
    Pose pose = new Pose();
    pose.rotation.setRotationVector(new Vec3(radians, 2 * radians, -radians));
    pose.translation.set(radians, 1, -radians);
    return pose.transform(RigidTransform.identity());
  }

  /** Returns 7 points along each edge of each voxel of a tool, world mm. */
  private static List<Vec3> toolPoints(BitCube bits, VoxelGrid grid, RigidTool tool, Pose pose) {
    Vec3 reference = tool.referenceMm(new Vec3());
    List<Vec3> points = new ArrayList<>();
    for (Vec3 inGrid : gridPoints(bits)) {
      Vec3 p = grid.gridToWorld(inGrid, new Vec3()).sub(reference, new Vec3());
      points.add(pose.transform(p, p));
    }
    return points;
  }

  private static List<Vec3> bodyPoints(Body body) {
    List<Vec3> points = new ArrayList<>();
    for (Vec3 inGrid : gridPoints(body.bits())) {
      Vec3 p = body.grid().gridToWorld(inGrid, new Vec3());
      points.add(body.pose().transform(p, p));
    }
    return points;
  }

  private static List<Vec3> gridPoints(BitCube bits) {
    List<Vec3> points = new ArrayList<>();
    for (int n = 0; n < bits.sizeX() * bits.sizeY() * bits.sizeZ(); n++) {
      int i = n % bits.sizeX();
      int j = n / bits.sizeX() % bits.sizeY();
      int k = n / bits.sizeX() / bits.sizeY();
      for (int at = 0; bits.get(i, j, k) && at < 7 * 7 * 7; at++) {
        points.add(new Vec3(i + at % 7 / 6.0, j + at / 7 % 7 / 6.0, k + at / 49 % 7 / 6.0));
      }
    }
    return points;
  }

  /** Whether a point lies well inside a solid voxel of a body. */
  private static boolean isSolid(Body body, Vec3 world) {
    Vec3 p = body.pose().inverseTransform(world, new Vec3());
    body.grid().worldToGrid(p, p);
    boolean isOnFace = isWhole(p.x) || isWhole(p.y) || isWhole(p.z);
    return !isOnFace
        && body.bits().get((int) Math.floor(p.x), (int) Math.floor(p.y), (int) Math.floor(p.z));
  }

  private static boolean isWhole(double coordinate) {
    return Math.abs(coordinate - Math.rint(coordinate)) < 1e-6;
  }

  private static double distance(List<Vec3> some, List<Vec3> others) {
    double least = Double.POSITIVE_INFINITY;
    for (Vec3 a : some) {
      for (Vec3 b : others) {
        double squared = (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
        least = Math.min(least, squared + (a.z - b.z) * (a.z - b.z));
      }
    }
    return Math.sqrt(least);
  }
}
