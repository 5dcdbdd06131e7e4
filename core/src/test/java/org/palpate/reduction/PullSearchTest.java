package org.palpate.reduction;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.reduction.PullSearch.Pulled;
import org.palpate.rigid.MovableShapes;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

class PullSearchTest {
  private static final double REACH_MM = 30;
  private static final Vec3 DOWN = new Vec3(0, 0, -1);

  @Test
  void aPegComesOutOfAHoleByAStraightPull() {
    BodyScene scene = scene(BlockWithHole.bits(), BlockWithHole.PEG);
    Pulled pulled = search(scene).straight(1, DOWN, REACH_MM, 1).get(0);
    assertTrue(pulled.isOut());
    assertTrue(pulled.farthestMm() >= 0.9 * REACH_MM, pulled.toString());
    requireFree(scene, pulled.way());
    Pose out = pulled.way().get(pulled.way().size() - 1);
    assertTrue(out.translation.z > 20, "the hole opens upwards: " + out);
    assertTrue(scene.body(1).pose().sameBits(new Pose()), "is back in its place");
  }

  @Test
  void aPegThatIsShutInDoesNotComeOut() {
    BitCube shut = BlockWithHole.bits();
    add(shut, 6, 6, 14, 10, 10, 16);
    PullSearch search = search(scene(shut, BlockWithHole.PEG));
    assertEquals(List.of(), search.straight(1, DOWN, REACH_MM, 1));
    Pulled around = search.around(1, REACH_MM, 1);
    assertFalse(around.isOut());
    assertEquals(2.5, around.farthestMm(), 1, "comes as far as the lid");
  }

  @Test
  void severalWaysLeadInDifferentDirectionsAndThatWithTheLeastDetourComesFirst() {
    BodyScene scene = scene(box(0, 0, 0, 16, 16, 4), box(6, 6, 4, 10, 10, 8));
    List<Pulled> ways = search(scene).straight(1, DOWN, REACH_MM, 5);
    assertEquals(5, ways.size());
    RigidTool peg = MovableShapes.ofPoints(scene).shapes().get(1);
    for (int n = 0; n < ways.size(); n++) {
      assertTrue(n == 0 || ways.get(n).detourMm() >= ways.get(n - 1).detourMm(), "way " + n);
      requireFree(scene, ways.get(n).way());
      for (int m = 0; m < n; m++) {
        Vec3 direction = Ways.direction(ways.get(n).way(), peg);
        double cosine = direction.dot(Ways.direction(ways.get(m).way(), peg));
        assertTrue(cosine < 0.98, "ways " + n + " and " + m + ": " + cosine);
      }
    }
  }

  /** The channel leads down, sideways and up, so every straight pull ends in it. */
  @Test
  void aPegComesOutOfABentChannelByRandomPulls() {
    BitCube bent = box(0, 0, 0, 16, 16, 16);
    remove(bent, 10, 6, 2, 12, 8, 9);
    remove(bent, 4, 6, 2, 12, 8, 4);
    remove(bent, 4, 6, 2, 6, 8, 16);
    BodyScene scene = scene(bent, box(10, 6, 7, 12, 8, 9));
    PullSearch search = search(scene);
    assertEquals(List.of(), search.straight(1, DOWN, REACH_MM, 1));
    Pulled pulled = search.around(1, REACH_MM, 1);
    assertTrue(pulled.isOut(), pulled.farthestMm() + " mm");
    requireFree(scene, pulled.way());
  }

  /** Requires that no sample point of the peg lies in the block along a way. */
  private static void requireFree(BodyScene scene, List<Pose> way) {
    RigidTool peg = MovableShapes.ofPoints(scene).shapes().get(1);
    assertTrue(way.get(0).sameBits(new Pose()), "begins in its place");
    for (int n = 1; n < way.size(); n++) {
      Vec3[] from = ReductionPlan.points(peg, way.get(n - 1));
      Vec3[] to = ReductionPlan.points(peg, way.get(n));
      for (int p = 0; p < to.length; p++) {
        for (double part = 0; part <= 1; part += 0.25) {
          Vec3 at = from[p].mul(1 - part, new Vec3()).add(to[p].mul(part, new Vec3()), new Vec3());
          int i = (int) Math.floor(at.x);
          int j = (int) Math.floor(at.y);
          int k = (int) Math.floor(at.z);
          assertFalse(scene.body(0).bits().get(i, j, k), "step " + n + " meets a voxel: " + at);
        }
      }
    }
  }

  private static PullSearch search(BodyScene scene) {
    return new PullSearch(scene, MovableShapes.ofPoints(scene));
  }

  private static BodyScene scene(BitCube block, BitCube peg) {
    return new BodyScene(
        List.of(
            new Body("block", block, BlockWithHole.GRID, Mobility.FIXED),
            new Body("peg", peg, BlockWithHole.GRID, Mobility.MOVABLE)));
  }

  /** Returns a box of voxels in the grid of the block. */
  static BitCube box(int i0, int j0, int k0, int i1, int j1, int k1) {
    BitCube bits = new BitCube(16, 16, 16);
    add(bits, i0, j0, k0, i1, j1, k1);
    return bits;
  }

  private static void add(BitCube bits, int i0, int j0, int k0, int i1, int j1, int k1) {
    for (int k = k0; k < k1; k++) {
      for (int j = j0; j < j1; j++) {
        for (int i = i0; i < i1; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  private static void remove(BitCube bits, int i0, int j0, int k0, int i1, int j1, int k1) {
    for (int k = k0; k < k1; k++) {
      for (int j = j0; j < j1; j++) {
        for (int i = i0; i < i1; i++) {
          bits.clear(i, j, k);
        }
      }
    }
  }
}
