package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.rigid.ToolVerifier.EditOutcome;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.volume.BitCube;

/**
 * Decides for one body whether a proposed motion of a tool is free: no leg of any point touches the
 * barrier. A leg is the exact segment between the point's coordinates at the committed and at the
 * proposed pose. The answer is that of casting every leg exactly; what is left out is proved to be
 * empty:
 *
 * <ul>
 *   <li>A node of the tool's tree, if all around its centre is empty up to its radius plus the path
 *       of its centre. The legs of its points lie between two balls of that radius.
 *   <li>A point or a leaf, as long as its odometer has not used up the empty cube that was found
 *       around it. Every committed motion adds the most that any point moved along an axis.
 *   <li>A leg whose bounding box is empty.
 * </ul>
 *
 * <p>Work is counted in points looked at as if no odometer and no box had left any out. Belongs to
 * the haptic thread; allocates nothing.
 */
final class BodyVerifier {
  /** Covers the rounding of coordinates where clearances are compared, cells. */
  private static final double ROUNDING_CELLS = 1e-6;

  /** Rounding of a coordinate relative to the offset of its map: a few units in the last place. */
  private static final double RELATIVE_ROUNDING = 0x1p-49;

  /** The odometer starts anew here, before its rounding could matter. */
  private static final double LONGEST_ODOMETER = 1 << 20;

  final Barrier barrier;

  /** Maps of the committed and the proposed pose to the body's grid. */
  final AffineMap from = new AffineMap();

  final AffineMap to = new AffineMap();

  private final RigidTool tool;
  private final SphereTree tree;
  private final int index;
  private final boolean skips;
  private final int highest;
  private final double inverseCellMm;

  /** The same maps to the cells of the highest level. */
  private final AffineMap cellsFrom = new AffineMap();

  private final AffineMap cellsTo = new AffineMap();
  private final AffineMap levelFrom = new AffineMap();
  private final AffineMap levelTo = new AffineMap();
  private final byte[] level;
  private int reducedCount;
  private int raiseNext;

  private double odometer;
  private final double[] freeUntil;
  private final double[] leafFreeUntil;

  /** The most that any point moves along an axis by the proposal, cells, rounded up. */
  private double travel;

  /** By how much points may leave their chords in a step with a large turn, per mm of radius. */
  private double arcPerMm;

  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final IntBox changed = new IntBox();
  private final Vec3 position = new Vec3();
  private long looked;

  /**
   * Creates a verifier.
   *
   * @param index of the body in its scene, which hits carry
   * @param skips whether to leave out what is proved to be empty; answers are the same
   */
  BodyVerifier(RigidTool tool, Barrier barrier, int index, boolean skips) {
    this.tool = tool;
    this.barrier = barrier;
    this.index = index;
    this.skips = skips;
    tree = tool.tree();
    highest = barrier.highest;
    inverseCellMm = 1 / barrier.cellMm;
    level = new byte[tool.count()];
    freeUntil = new double[tool.count()];
    leafFreeUntil = new double[tree.leaves()];
  }

  /** Returns how many points were looked at, or would have been without odometers and boxes. */
  long looked() {
    return looked;
  }

  /** Returns how many points keep less than the full clearance. */
  int reducedCount() {
    return reducedCount;
  }

  /** Returns the level that a point keeps. */
  int level(int point) {
    return level[point];
  }

  /**
   * Puts the tool at a pose without a motion. Points that touch a level keep a lower one.
   *
   * @param least the lowest level that points may have
   * @return whether no point touches that lowest level; if not, nothing was changed but the levels
   */
  boolean place(Pose pose, int least) {
    barrier.body.toolToGrid(pose, to);
    barrier.toCells(to, highest, cellsTo);
    reducedCount = 0;
    for (int n = 0; n < tool.count(); n++) {
      int free = freeLevel(n, to, highest);
      if (free < least) {
        return false;
      }
      level[n] = (byte) free;
      reducedCount += free < highest ? 1 : 0;
    }
    from.set(to);
    cellsFrom.set(cellsTo);
    forgetEmptySpace();
    return true;
  }

  /**
   * Returns the highest level, up to a limit, that a point does not touch; -1 if it touches all.
   */
  private int freeLevel(int n, AffineMap toGrid, int limit) {
    int free = limit;
    while (free >= 0 && touches(n, toGrid, free)) {
      free--;
    }
    return free;
  }

  private boolean touches(int n, AffineMap toGrid, int atLevel) {
    barrier.toCells(toGrid, atLevel, levelTo);
    double x = levelTo.x(tool.x(n), tool.y(n), tool.z(n));
    double y = levelTo.y(tool.x(n), tool.y(n), tool.z(n));
    double z = levelTo.z(tool.x(n), tool.y(n), tool.z(n));
    return caster.cast(barrier.cubes[atLevel], ray.from(x, y, z).to(x, y, z), hit);
  }

  private void forgetEmptySpace() {
    odometer = 0;
    Arrays.fill(freeUntil, -1);
    Arrays.fill(leafFreeUntil, -1);
  }

  /** Takes over edits of the body. Points that now touch a level keep a lower one. */
  EditOutcome takeEdits() {
    changed.clear();
    if (!barrier.takeEdits(changed)) {
      return EditOutcome.NONE;
    }
    forgetEmptySpace();
    if (changed.isEmpty()) {
      return EditOutcome.FREE;
    }
    changed.grow(barrier.reachVoxels() + 1);
    boolean free = true;
    for (int n = 0; n < tool.count(); n++) {
      if (isInChange(n)) {
        int now = freeLevel(n, from, level[n]);
        free &= now >= 0;
        reducedCount += now < highest && level[n] == highest ? 1 : 0;
        level[n] = (byte) Math.max(0, now);
      }
    }
    return free ? EditOutcome.FREE : EditOutcome.BURIED;
  }

  private boolean isInChange(int n) {
    from.transform(tool.point(n, position), position);
    return position.x >= changed.lowX
        && position.x <= changed.highX + 1
        && position.y >= changed.lowY
        && position.y <= changed.highY + 1
        && position.z >= changed.lowZ
        && position.z <= changed.highZ + 1;
  }

  /** Sets the pose that is proposed. */
  void propose(Pose candidate) {
    barrier.body.toolToGrid(candidate, to);
    barrier.toCells(to, highest, cellsTo);
    travel = longestMotion();
  }

  /** Returns the most that a point moves along an axis, cells, rounded up. */
  private double longestMotion() {
    AffineMap a = cellsFrom;
    AffineMap b = cellsTo;
    double alongX = motion(b.mXX - a.mXX, b.mXY - a.mXY, b.mXZ - a.mXZ, b.offsetX - a.offsetX);
    double alongY = motion(b.mYX - a.mYX, b.mYY - a.mYY, b.mYZ - a.mYZ, b.offsetY - a.offsetY);
    double alongZ = motion(b.mZX - a.mZX, b.mZY - a.mZY, b.mZZ - a.mZZ, b.offsetZ - a.offsetZ);
    return Math.max(alongX, Math.max(alongY, alongZ)) + rounding();
  }

  private double motion(double rowX, double rowY, double rowZ, double offset) {
    double turned = Math.sqrt(rowX * rowX + rowY * rowY + rowZ * rowZ) * tool.radiusMm();
    return (Math.abs(offset) + turned) * (1 + 1e-12);
  }

  /** Returns a bound of what rounding adds to the motion of a point, cells. */
  private double rounding() {
    double far =
        Math.abs(cellsFrom.offsetX)
            + Math.abs(cellsFrom.offsetY)
            + Math.abs(cellsFrom.offsetZ)
            + Math.abs(cellsTo.offsetX)
            + Math.abs(cellsTo.offsetY)
            + Math.abs(cellsTo.offsetZ)
            + 6 * tool.radiusMm() * inverseCellMm;
    return RELATIVE_ROUNDING * far;
  }

  /**
   * Makes the proposal the committed pose. The proposal is free, or it is a pose from which the
   * tool came in this frame and to which it is taken back.
   */
  void commit() {
    odometer += travel;
    from.set(to);
    cellsFrom.set(cellsTo);
    if (odometer > LONGEST_ODOMETER) {
      forgetEmptySpace();
    }
  }

  /**
   * Looks for legs of the proposal that touch the barrier.
   *
   * @param turnRad rotation of the proposal if it is too large for chords to stand for arcs, else
   *     0; then whole nodes must be ruled out with their arcs
   * @param firstOnly whether to stop at the first leg that touches
   * @param hits gets the earliest hit of each leaf
   * @return whether no leg touches
   */
  boolean isFree(double turnRad, boolean firstOnly, LegHits hits) {
    int before = hits.count();
    arcPerMm = turnRad == 0 ? 0 : (1 - Math.cos(Math.min(Math.PI, turnRad) / 2)) * inverseCellMm;
    int node = 0;
    while (node < tree.nodes()) {
      boolean isLeaf = tree.isLeaf(node);
      if (isLeaf && turnRad == 0) {
        lookAtLeaf(node, hits);
        if (hits.count() > before && (firstOnly || hits.isFull())) {
          return false;
        }
        node = tree.skip(node);
      } else if (isRuledOut(node)) {
        node = tree.skip(node);
      } else if (isLeaf) {
        return false;
      } else {
        node++;
      }
    }
    return hits.count() == before;
  }

  /** Whether all around the node is empty, as far as its points go. */
  private boolean isRuledOut(int node) {
    double a = tree.x(node);
    double b = tree.y(node);
    double c = tree.z(node);
    double x = cellsFrom.x(a, b, c);
    double y = cellsFrom.y(a, b, c);
    double z = cellsFrom.z(a, b, c);
    double dx = Math.abs(cellsTo.x(a, b, c) - x);
    double dy = Math.abs(cellsTo.y(a, b, c) - y);
    double dz = Math.abs(cellsTo.z(a, b, c) - z);
    double path = Math.max(dx, Math.max(dy, dz));
    double radius = tree.radius(node);
    double needed = radius * inverseCellMm + path + ROUNDING_CELLS;
    if (arcPerMm > 0) {
      needed += arcPerMm * (Math.sqrt(a * a + b * b + c * c) + radius);
    }
    return barrier.clearance.at(x, y, z) > needed;
  }

  private void lookAtLeaf(int node, LegHits hits) {
    int end = tree.end(node);
    int leaf = tree.leaf(node);
    looked += end - tree.first(node);
    double reach = odometer + travel;
    if (skips && (reach <= leafFreeUntil[leaf] || restsFor(node, leaf))) {
      return;
    }
    int firstHit = hits.count();
    double until = Double.POSITIVE_INFINITY;
    for (int n = tree.first(node); n < end; n++) {
      if (!(skips && reach <= freeUntil[n])) {
        look(n, hits);
        if (hits.count() > firstHit + 1) {
          hits.keepEarliestFrom(firstHit);
        }
      }
      until = Math.min(until, freeUntil[n]);
    }
    leafFreeUntil[leaf] = until;
  }

  /** Whether all around the leaf is empty; if so it rests until its points may have left that. */
  private boolean restsFor(int node, int leaf) {
    double a = tree.x(node);
    double b = tree.y(node);
    double c = tree.z(node);
    double around =
        barrier.clearance.at(cellsFrom.x(a, b, c), cellsFrom.y(a, b, c), cellsFrom.z(a, b, c));
    double empty = around - tree.radius(node) * inverseCellMm - ROUNDING_CELLS;
    if (empty <= travel) {
      return false;
    }
    leafFreeUntil[leaf] = odometer + empty;
    return true;
  }

  /** Looks at one point's leg, with its odometer. Returns whether it is free. */
  boolean isPointFree(int n, LegHits hits) {
    looked++;
    int before = hits.count();
    if (!(skips && odometer + travel <= freeUntil[n])) {
      look(n, hits);
    }
    return hits.count() == before;
  }

  private void look(int n, LegHits hits) {
    double a = tool.x(n);
    double b = tool.y(n);
    double c = tool.z(n);
    if (level[n] != highest) {
      lookAtReduced(n, hits);
      return;
    }
    double x = cellsFrom.x(a, b, c);
    double y = cellsFrom.y(a, b, c);
    double z = cellsFrom.z(a, b, c);
    BitCube cube = barrier.cubes[highest];
    double empty = skips ? emptyAround(cube, x, y, z) : 0;
    freeUntil[n] = odometer + empty;
    if (empty >= travel) {
      return;
    }
    double toX = cellsTo.x(a, b, c);
    double toY = cellsTo.y(a, b, c);
    double toZ = cellsTo.z(a, b, c);
    if (skips && EmptyBox.holds(cube, x, y, z, toX, toY, toZ)) {
      return;
    }
    cast(n, highest, ray.from(x, y, z).to(toX, toY, toZ), hits);
  }

  /** Returns half the edge of an empty cube around a point, cells; less than 0 if there is none. */
  private double emptyAround(BitCube cube, double x, double y, double z) {
    double near = EmptyBox.around(cube, x, y, z);
    if (near >= 2) {
      near = Math.max(near, barrier.clearance.at(x, y, z));
    }
    return near - ROUNDING_CELLS;
  }

  private void lookAtReduced(int n, LegHits hits) {
    int at = level[n];
    barrier.toCells(from, at, levelFrom);
    barrier.toCells(to, at, levelTo);
    levelFrom.transform(tool.point(n, position), position);
    ray.from(position.x, position.y, position.z);
    levelTo.transform(tool.point(n, position), position);
    ray.to(position.x, position.y, position.z);
    freeUntil[n] = -1;
    cast(n, at, ray, hits);
  }

  private void cast(int n, int atLevel, Ray leg, LegHits hits) {
    if (!caster.cast(barrier.cubes[atLevel], leg, hit)) {
      return;
    }
    freeUntil[n] = -1;
    hits.add(index, n, hit.t);
    if (hit.axis == RayHit.NO_AXIS) {
      return;
    }
    double start = hit.axis == 0 ? leg.fromX : hit.axis == 1 ? leg.fromY : leg.fromZ;
    double end = hit.axis == 0 ? leg.toX : hit.axis == 1 ? leg.toY : leg.toZ;
    int cell = hit.cell(hit.axis);
    boolean up = end > start;
    double gapCells = up ? cell - start : start - (cell + 1.0);
    double edgeMm = barrier.cellMm(atLevel, hit.axis);
    hits.setFace(hit.axis, up ? -1 : 1, gapCells * edgeMm);
  }

  /**
   * Raises the levels of points that have moved away from the body. Looks at a bounded number of
   * points and goes on with the next ones when it is called again.
   */
  void raiseLevels(int most) {
    for (int n = 0; n < most && reducedCount > 0; n++) {
      raiseNext = raiseNext + 1 < tool.count() ? raiseNext + 1 : 0;
      int now = level[raiseNext];
      if (now < highest && !touches(raiseNext, from, now + 1)) {
        level[raiseNext]++;
        freeUntil[raiseNext] = -1;
        leafFreeUntil[tree.leafOfPoint(raiseNext)] = -1;
        reducedCount -= now + 1 == highest ? 1 : 0;
      }
    }
  }
}
