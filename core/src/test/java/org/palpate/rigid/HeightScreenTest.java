package org.palpate.rigid;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.collision.CollisionDevice;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.skip.HeightScreen;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.testing.FilteredOracle;
import org.palpate.testing.RandomGeometry;
import org.palpate.testing.Seeds;
import org.palpate.volume.BitCube;

/** Casts every leg that a {@link HeightScreen} finds to be free, in exact arithmetic. */
class HeightScreenTest {
  private static final int EDGE = 28;
  private static final double ROUNDING_CELLS = 1e-6;

  private final SplittableRandom random = new SplittableRandom(Seeds.seed());
  private final FilteredOracle oracle = new FilteredOracle();
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 normal = new Vec3();
  private final Pose start = new Pose();
  private final Pose end = new Pose();
  private Body body;
  private RigidTool tool;
  private ClearanceLevels levels;
  private HeightScreen screen;
  private int nodesAbove;
  private int pointsAbove;
  private int touching;

  @BeforeEach
  void makeScene() {
    nextScene(0);
  }

  /** Makes a rough solid below a tilted plane, and a tool. */
  private void nextScene(int round) {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    normal.set(RandomGeometry.vector(random, 1));
    normal.mul(1 / normal.length(), normal);
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          if (height(new Vec3(i, j, k)) < random.nextDouble(-0.5, 0.5)) {
            bits.set(i, j, k);
          }
        }
      }
    }
    body = ToolScenes.unit("rough", bits);
    body.setPose(round % 3 == 0 ? new Pose() : RandomGeometry.pose(random, 10));
    tool =
        round % 2 == 0
            ? ToolSampler.ofShape(new BoxShape(11, 9, 1), 0.5)
            : ToolSampler.ofShape(RodShape.sphere(6), 0.6);
    Clearance clearance =
        round % 4 < 2 ? Clearance.POINTS : Clearance.ofWholeBody(tool, body.grid(), 0);
    levels = new ClearanceLevels(body, clearance, CollisionDevice.CPU);
    screen = screenOf(tool, levels);
  }

  private static HeightScreen screenOf(RigidTool tool, ClearanceLevels levels) {
    BitCube solids = levels.cubes[levels.highest];
    return new HeightScreen(tool, solids, levels.cellMm(levels.highest));
  }

  private double height(Vec3 at) {
    return at.sub(new Vec3(EDGE / 2.0, EDGE / 2.0, EDGE / 2.0), new Vec3()).dot(normal);
  }

  @Test
  void legsOfNodesAndPointsThatStayAboveTouchNothingAfterEditsToo() {
    for (int round = 0; round < 24; round++) {
      nextScene(round);
      for (int motion = 0; motion < 20; motion++) {
        if (motion % 4 == 3) {
          addVoxels();
        }
        screen.suggest(random.nextInt(6) == 0 ? unit() : normal);
        nextMotion();
        checkAll();
      }
    }
    assertTrue(nodesAbove > 300, nodesAbove + " nodes above");
    assertTrue(pointsAbove > 1_000, pointsAbove + " points above");
    assertTrue(touching > 1_000, touching + " legs touch");
  }

  private Vec3 unit() {
    Vec3 v = RandomGeometry.vector(random, 1);
    return v.mul(1 / v.length(), v);
  }

  private void addVoxels() {
    IntBox box = new IntBox();
    for (int n = 0; n < 3; n++) {
      int i = random.nextInt(EDGE);
      int j = random.nextInt(EDGE);
      int k = random.nextInt(EDGE);
      body.bits().set(i, j, k);
      box.include(i, j, k);
    }
    body.voxelsChanged(box);
    levels.takeEdits();
  }

  /** Moves the tool about a place near the plane, at odd angles or flat on it. */
  private void nextMotion() {
    Vec3 lift = normal.mul(random.nextDouble(-1, 4), new Vec3());
    Vec3 centre = new Vec3(EDGE / 2.0, EDGE / 2.0, EDGE / 2.0).add(lift, new Vec3());
    start.translation.set(body.pose().transform(centre, centre));
    Vec3 up = body.pose().rotation.rotate(normal, new Vec3());
    double tilt = Math.acos(up.z) / Math.hypot(up.x, up.y);
    start.rotation.setRotationVector(new Vec3(-up.y * tilt, up.x * tilt, 0));
    double size = Math.pow(10, random.nextDouble(-3, 0.7));
    Vec3 shift = RandomGeometry.vector(random, size);
    Vec3 turn = RandomGeometry.vector(random, 0.2 * size);
    start.displace(shift, turn, 1, new Quaternion(), end);
    body.toolToGrid(body.pose(), start, from);
    levels.toCells(from, levels.highest, from);
    body.toolToGrid(body.pose(), end, to);
    levels.toCells(to, levels.highest, to);
    screen.begin(from, to, ROUNDING_CELLS, body.edits());
  }

  private void checkAll() {
    SphereTree tree = tool.tree();
    for (int node = 0; node < tree.nodes(); node++) {
      boolean isAbove = screen.isAbove(node);
      nodesAbove += isAbove ? 1 : 0;
      if (tree.isLeaf(node)) {
        checkLeaf(tree, node, isAbove);
      } else if (isAbove) {
        checkLeaves(tree, node);
      }
    }
  }

  private void checkLeaves(SphereTree tree, int node) {
    for (int below = node + 1; below < tree.skip(node); below++) {
      for (int n = tree.first(below); tree.isLeaf(below) && n < tree.end(below); n++) {
        assertFalse(isTouching(n), "node " + node + ", point " + n);
      }
    }
  }

  private void checkLeaf(SphereTree tree, int leaf, boolean isAbove) {
    for (int n = tree.first(leaf); n < tree.end(leaf); n++) {
      boolean isTouching = isTouching(n);
      touching += isTouching ? 1 : 0;
      boolean isFree = isAbove || screen.isPointAbove(n);
      pointsAbove += isFree && !isAbove ? 1 : 0;
      assertFalse(isFree && isTouching, "leaf " + leaf + ", point " + n);
    }
  }

  private boolean isTouching(int n) {
    Vec3 at = from.transform(tool.point(n, new Vec3()), new Vec3());
    Vec3 then = to.transform(tool.point(n, new Vec3()), new Vec3());
    Ray leg = new Ray().from(at.x, at.y, at.z).to(then.x, then.y, then.z);
    return oracle.touchesAny(levels.cubes[levels.highest], leg);
  }

  @Test
  void nothingIsFoundWithoutANormalAndOutsideAVerification() {
    start.translation.set(EDGE + 40, 0, 0);
    body.toolToGrid(body.pose(), start, from);
    screen.begin(from, from, ROUNDING_CELLS, body.edits());
    assertFalse(screen.isAbove(0), "without a normal");
    screen.suggest(normal);
    assertFalse(screen.isAbove(0), "before a verification begins");
    screen.begin(from, from, ROUNDING_CELLS, body.edits());
    assertTrue(screen.isAbove(0), "far from the solid");
    assertTrue(screen.isPointAbove(0));
    screen.end();
    assertFalse(screen.isAbove(0), "after a verification");
    assertFalse(screen.isPointAbove(0));
  }

  @Test
  void aFaceThatLiesOnAPlaneNeedsNoTestOfPoints() {
    BodyScene scene = new BodyScene(List.of(ToolScenes.unit("block", ToolScenes.block(40, 40, 9))));
    RigidTool plate = ToolSampler.ofShape(new BoxShape(20, 20, 1), 0.5);
    ClearanceLevels ofBlock =
        new ClearanceLevels(scene.body(0), Clearance.POINTS, CollisionDevice.CPU);
    HeightScreen flat = screenOf(plate, ofBlock);
    flat.suggest(new Vec3(0, 0, 1));
    start.translation.set(20, 20, 9.5 + 1e-4);
    end.translation.set(20.4, 20.3, 9.5 + 1e-4);
    scene.body(0).toolToGrid(start, from);
    scene.body(0).toolToGrid(end, to);
    flat.begin(from, to, ROUNDING_CELLS, 0);
    for (int node = 0; node < plate.tree().nodes(); node++) {
      if (plate.tree().isLeaf(node)) {
        assertTrue(flat.isAbove(node), "leaf " + node);
      }
    }
    end.translation.z = 8.99; // the end of the motion is below the plane
    start.translation.z = 9.6;
    scene.body(0).toolToGrid(end, to);
    flat.begin(from, to, ROUNDING_CELLS, 0);
    assertFalse(flat.isAbove(0));
  }
}
