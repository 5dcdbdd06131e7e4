package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.body.Body;
import org.palpate.collision.MovingBoundsTree;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.geometry.WorldBox;

/**
 * Finds the movers that a moving one may touch. Each mover has a box in the world that contains its
 * sample points and all cells that sample points of others must not touch. The box follows each
 * committed motion and each edit.
 *
 * <p>A mover that is not found touches nothing: no leg between the two, at the levels of clearance
 * that points may have, meets a solid cell. What is found depends on committed poses, edits and the
 * query alone. Haptic thread only; allocates nothing after its creation.
 */
final class MoverBroadPhase {
  /** The margin of each box against rounding, mm; a part of its coordinates is added. */
  private static final double MARGIN_MM = 1e-5;

  private static final double MARGIN_PART = 1e-12;

  /** The slack of the tree, shortest edges: a mover that travels less is not inserted anew. */
  private static final double SLACK_EDGES = 8;

  private final Mover[] movers;
  private final boolean skips;
  private final MovingBoundsTree tree;

  /** The box of each mover at its committed pose. */
  private final WorldBox[] boxes;

  /** The map of each body from its grid to the world at rest; null for the tool. */
  private final AffineMap[] gridToRest;

  /** The number of voxels by which the grown solids of each body reach beyond a voxel. */
  private final int[] growthVoxels;

  /** The largest error of the place of a grown cell of each body, mm. */
  private final double[] distortionMm;

  private final long[] editsSeen;
  private final AffineMap posed = new AffineMap();
  private final AffineMap gridToWorld = new AffineMap();
  private final WorldBox query = new WorldBox();

  /**
   * Creates a broad phase of movers at their committed poses. The tool, which comes last, is not
   * found before its first motion is committed.
   *
   * @param growthVoxels the number of voxels by which the grown solids of each body reach beyond a
   *     voxel
   * @param edgeMm the shortest voxel edge of the scene
   * @param skips whether to search a tree instead of all boxes; what is found is the same
   */
  MoverBroadPhase(Mover[] movers, int[] growthVoxels, double edgeMm, boolean skips) {
    this.movers = movers;
    this.growthVoxels = growthVoxels;
    this.skips = skips;
    tree = new MovingBoundsTree(movers.length, SLACK_EDGES * edgeMm);
    boxes = new WorldBox[movers.length];
    gridToRest = new AffineMap[movers.length];
    distortionMm = new double[movers.length];
    editsSeen = new long[movers.length];
    for (int n = 0; n < movers.length; n++) {
      boxes[n] = new WorldBox();
      Body body = movers[n].body;
      if (body != null) {
        gridToRest[n] = body.grid().gridToWorld(new AffineMap());
        distortionMm[n] = movers[n].distortionMm(growthVoxels[n]);
        editsSeen[n] = body.edits();
        refit(n);
      }
      movers[n].setBroadPhase(this, n);
    }
  }

  /**
   * Computes the box of a mover anew from its committed pose. The bounds of voxels do not shrink
   * where some are removed, so the box of a body keeps its sample points.
   */
  void refit(int index) {
    Mover mover = movers[index];
    WorldBox box = boxes[index].clear();
    if (mover.body == null) {
      box.include(mover.pose.translation).grow(mover.shape.radiusMm() * (1 + 1e-9));
    } else {
      IntBox voxels = mover.body.bits().bounds();
      if (voxels.isEmpty()) {
        return; // It never had a voxel, so nothing can touch it, and the tree does not hold it.
      }
      posed.set(mover.bodyPose()).multiply(gridToRest[index], gridToWorld);
      box.setImage(gridToWorld, voxels, growthVoxels[index]).grow(distortionMm[index]);
    }
    grow(box);
    tree.put(index, box);
  }

  private static void grow(WorldBox box) {
    box.grow(MARGIN_MM + MARGIN_PART * box.farthestMm());
  }

  /** Makes the boxes of bodies that were edited contain their voxels. */
  void takeEdits() {
    for (int n = 0; n < movers.length; n++) {
      Body body = movers[n].body;
      if (body != null && body.edits() != editsSeen[n]) {
        editsSeen[n] = body.edits();
        refit(n);
      }
    }
  }

  /**
   * Finds the movers that a ball may touch while its centre moves along a straight line.
   *
   * @param found gets the bits of the movers that are found, by index
   */
  void find(Vec3 from, Vec3 to, double radiusMm, long[] found) {
    Arrays.fill(found, 0);
    query.clear().include(from).include(to).grow(radiusMm);
    grow(query);
    if (skips) {
      tree.find(query, found);
      return;
    }
    for (int n = 0; n < movers.length; n++) {
      if (boxes[n].meets(query)) {
        found[n >> 6] |= 1L << n;
      }
    }
  }
}
