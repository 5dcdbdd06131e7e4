package org.palpate.rigid;

import org.palpate.collision.EmptyBox;
import org.palpate.collision.LegScreen;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.ArcBound;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.rigid.skip.HeightScreen;
import org.palpate.rigid.skip.Odometer;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.statistics.SkipCounters;
import org.palpate.statistics.SkipKind;
import org.palpate.volume.BitCube;

/**
 * Verifies proposed motions of the sample points of one {@link Mover} relative to the voxels of
 * another: whether any leg touches a solid. A leg is the exact segment between a point's grid
 * coordinates at the committed poses of both and at the proposed ones. It makes no difference which
 * of the two moves. Levels and empty cubes of the points stay valid if the hand takes another body.
 *
 * <p>The answer is that of casting every leg exactly. What is skipped is proved to be empty:
 *
 * <ul>
 *   <li>A node of the tool's tree, if its centre has an empty cube around it. The cube reaches
 *       farther than the node's radius plus the path of its centre, so it holds all legs of the
 *       node.
 *   <li>A point or a leaf, until its odometer has used up the empty cube that was found around it.
 *       Each committed motion adds the longest motion of any point along an axis.
 *   <li>A leg whose bounding box is empty.
 *   <li>A node or a point that {@link HeightScreen} finds to stay above all solids around it.
 *   <li>A leg that {@link LegScreen} finds to be free, and the empty cube that it finds around the
 *       leg's start. Here the device is believed.
 * </ul>
 *
 * <p>Work is counted in tested points. Points that odometers and boxes skip count too. Belongs to
 * the haptic thread; allocates nothing.
 */
final class BodyVerifier {
  /** The least allowance for the rounding of coordinates where clearances are compared, cells. */
  private static final double LEAST_ROUNDING_CELLS = 1e-6;

  /**
   * The rounding of a coordinate relative to the offset of its map: some units in the last place.
   */
  private static final double RELATIVE_ROUNDING = 0x1p-49;

  /** The mover that carries the sample points. */
  final Mover points;

  /** The body whose voxels the points must not touch. */
  final Mover solid;

  final ClearanceLevels levels;

  /** Finds free legs of the highest level. */
  final LegScreen screen;

  /** Finds points that stay above all solids around them. */
  final HeightScreen heights;

  /** The maps from the points' frame to the body's grid at the committed and the proposed poses. */
  private final AffineMap from = new AffineMap();

  private final AffineMap to = new AffineMap();

  private final RigidTool tool;
  private final SphereTree tree;
  private final boolean skips;
  private final int highest;
  private final double inverseCellMm;

  /** The same maps to the cells of the highest level. */
  private final AffineMap cellsFrom = new AffineMap();

  private final AffineMap cellsTo = new AffineMap();
  private final byte[] level;
  private int reducedCount;
  private int raiseNext;

  /** The versions of the committed poses to which the maps belong. */
  private long pointsSeen;

  private long solidSeen;

  private final Odometer odometer;

  /** The longest motion of any point along an axis by the proposal, cells, rounded up. */
  private double travel;

  /**
   * The allowance for the rounding of coordinates at the committed and the proposed pose, cells.
   */
  private double roundingCells;

  /** The deviation of arcs from chords in the present call of {@link #isFree}; null for none. */
  private ArcBound arcs;

  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final IntBox edited = new IntBox();
  private final IntBox changed = new IntBox();
  private final Vec3 position = new Vec3();
  private final EnclosureCheck enclosure;
  private long editsSeen;
  private long tested;
  private long looked;

  /**
   * Creates a verifier of points that have not been placed yet.
   *
   * @param points the mover that carries the sample points
   * @param solid the body whose voxels they must not touch
   * @param skips whether to leave out what is proved to be empty; answers are the same
   */
  BodyVerifier(Mover points, Mover solid, ClearanceLevels levels, boolean skips) {
    this.points = points;
    this.solid = solid;
    this.levels = levels;
    this.skips = skips;
    tool = points.shape;
    tree = tool.tree();
    highest = levels.highest;
    inverseCellMm = 1 / levels.cellMm;
    level = new byte[tool.count()];
    odometer = new Odometer(tool.count(), tree.leaves());
    screen = new LegScreen(levels.onDevice.newBatch(tool));
    heights = new HeightScreen(tool, levels.cubes[highest], levels.cellMm(highest));
    enclosure = new EnclosureCheck(this);
    editsSeen = levels.body.edits();
  }

  /** Whether both movers are in the scene. */
  boolean isPresent() {
    return points.isPresent() && solid.isPresent();
  }

  /** Returns the other mover of the two. */
  Mover other(Mover one) {
    return one == points ? solid : points;
  }

  /** Returns the check whether the solid of the points encloses voxels. */
  EnclosureCheck enclosure() {
    return enclosure;
  }

  /** Returns the number of tested points, with those that odometers and boxes skipped. */
  long tested() {
    return tested;
  }

  /** Adds skipped work. A point within its empty cube counts as {@link SkipKind#NEIGHBOURS}. */
  void addSkips(SkipCounters dest) {
    caster.addSkips(dest);
    dest.add(SkipKind.NEIGHBOURS, tested - looked);
  }

  /** Returns the number of points that keep less than the full clearance. */
  int reducedCount() {
    return reducedCount;
  }

  /** Returns the level that a point keeps. */
  int level(int point) {
    return level[point];
  }

  /**
   * Places the points without a motion. A point keeps the highest level that it does not touch.
   *
   * @param ofPoints the pose of the points
   * @param ofBody the pose of the body, rest to present
   * @param least the lowest level that points may keep; -1 to place points that touch a voxel too,
   *     all legs of which will then touch it
   * @return whether each point keeps at least that level; if not, only levels have changed
   */
  boolean place(Pose ofPoints, Pose ofBody, int least) {
    levels.takeEdits(); // or a solid that was added since would be seen at the lowest level only
    levels.body.toolToGrid(ofBody, ofPoints, to);
    levels.toCells(to, highest, cellsTo);
    reducedCount = 0;
    for (int n = 0; n < tool.count(); n++) {
      int free = levels.freeLevel(tool.point(n, position), to, highest, caster);
      if (free < least) {
        return false;
      }
      level[n] = (byte) Math.max(0, free);
      reducedCount += free < highest ? 1 : 0;
    }
    takeProposal();
    odometer.reset();
    return true;
  }

  /** Returns the box of the voxels that the last call of {@link #takeEdits} found to be edited. */
  IntBox editedVoxels() {
    return edited;
  }

  /** Applies edits of the body. Points that now touch their level keep a lower one. */
  Mover.EditOutcome takeEdits() {
    edited.clear();
    long edits = levels.body.edits();
    if (edits == editsSeen) {
      return Mover.EditOutcome.NONE;
    }
    levels.body.includeChanges(editsSeen, edited);
    editsSeen = edits;
    levels.takeEdits();
    catchUp();
    odometer.reset();
    if (edited.isEmpty()) {
      return Mover.EditOutcome.FREE;
    }
    changed.set(edited).grow(levels.reachVoxels() + 1);
    boolean free = true;
    for (int n = 0; n < tool.count(); n++) {
      if (isInChange(n)) {
        int now = levels.freeLevel(tool.point(n, position), from, level[n], caster);
        free &= now >= 0;
        reducedCount += now < highest && level[n] == highest ? 1 : 0;
        level[n] = (byte) Math.max(0, now);
      }
    }
    return free ? Mover.EditOutcome.FREE : Mover.EditOutcome.COLLIDING;
  }

  private boolean isInChange(int n) {
    from.transform(tool.point(n, position), position);
    return changed.touches(position);
  }

  /** Returns the map from the points' frame to the body's grid at the committed poses. */
  AffineMap from() {
    catchUp();
    return from;
  }

  /**
   * Takes the committed poses. While the two are so far from each other that they are not found in
   * the {@link MoverBroadPhase}, their motions are not proposed to this.
   */
  private void catchUp() {
    if (pointsSeen != points.version() || solidSeen != solid.version()) {
      proposeMaps(points.pose, solid.bodyPose());
      commit();
    }
  }

  /**
   * Proposes a motion from the committed poses to others.
   *
   * @param ofPoints the pose of the points
   * @param ofBody the pose of the body, rest to present
   */
  void propose(Pose ofPoints, Pose ofBody) {
    catchUp();
    proposeMaps(ofPoints, ofBody);
  }

  private void proposeMaps(Pose ofPoints, Pose ofBody) {
    levels.body.toolToGrid(ofBody, ofPoints, to);
    levels.toCells(to, highest, cellsTo);
    roundingCells = LEAST_ROUNDING_CELLS + rounding();
    travel = cellsFrom.longestMotionTo(cellsTo, tool.radiusMm()) + rounding();
  }

  /** Announces the proposal to the device; see {@link MoverVerifier#announce}. */
  void announce(boolean first) {
    if (isPresent()) {
      screen.announce(cellsFrom, cellsTo, first);
    }
  }

  /** Returns a bound of the rounding of a coordinate and of a motion, cells. */
  private double rounding() {
    double far = cellsFrom.sumOfOffsets(cellsTo) + 6 * tool.radiusMm() * inverseCellMm;
    return RELATIVE_ROUNDING * far;
  }

  /**
   * Commits the proposal. It is free, it leads back to poses that were committed before while
   * nothing else has moved, or it takes over what was committed while the two were far apart.
   */
  void commit() {
    odometer.add(travel);
    takeProposal();
  }

  private void takeProposal() {
    from.set(to);
    cellsFrom.set(cellsTo);
    pointsSeen = points.version();
    solidSeen = solid.version();
  }

  /**
   * Finds the legs of the proposal that touch a solid.
   *
   * @param arcBound the deviation of arcs from chords if chords cannot stand for arcs; else null.
   *     If there is one, the proposal is free only if whole nodes are culled together with their
   *     arcs
   * @param firstOnly whether to stop at the first leg that touches a solid
   * @param hits receives the earliest hit of each leaf
   * @return whether no leg touches a solid
   */
  boolean isFree(ArcBound arcBound, boolean firstOnly, LegHits hits) {
    arcs = arcBound;
    if (arcs != null || !levels.areCurrent()) {
      return isTreeFree(firstOnly, hits);
    }
    long before = looked;
    screen.begin(cellsFrom, cellsTo, levels.body.edits());
    heights.begin(cellsFrom, cellsTo, roundingCells, levels.body.edits());
    boolean free = isTreeFree(firstOnly, hits);
    heights.end();
    screen.end(looked - before, free || !(firstOnly || hits.isFull()));
    return free;
  }

  private boolean isTreeFree(boolean firstOnly, LegHits hits) {
    int before = hits.count();
    int node = 0;
    int aboveUntil = 0; // the node after those that stay above all solids around them
    while (node < tree.nodes()) {
      boolean isLeaf = tree.isLeaf(node);
      if (isLeaf && arcs == null) {
        testLeaf(node, node < aboveUntil, hits);
        if (hits.count() > before && (firstOnly || hits.isFull())) {
          return false;
        }
        node = tree.skip(node);
      } else if (isCulled(node)) {
        node = tree.skip(node);
      } else if (isLeaf) {
        return false;
      } else {
        if (skips && node >= aboveUntil && heights.isAbove(node)) {
          aboveUntil = tree.skip(node);
        }
        node++;
      }
    }
    return hits.count() == before;
  }

  /** Whether all around a node is empty as far as its points move. */
  private boolean isCulled(int node) {
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
    double needed = radius * inverseCellMm + path + roundingCells;
    if (arcs != null) {
      needed += arcs.deviationMm(a, b, c, radius) * inverseCellMm;
    }
    return levels.clearance.at(x, y, z) > needed;
  }

  private void testLeaf(int node, boolean isAbove, LegHits hits) {
    int end = tree.end(node);
    int leaf = tree.leaf(node);
    tested += end - tree.first(node);
    if (isAbove) {
      return;
    }
    if (skips
        && (odometer.isLeafFree(leaf, travel)
            || isLeafInEmptySpace(node, leaf)
            || heights.isAbove(node))) {
      return;
    }
    int firstHit = hits.count();
    for (int n = tree.first(node); n < end; n++) {
      if (!(skips && (odometer.isPointFree(n, travel) || heights.isPointAbove(n)))) {
        testLeg(n, hits);
        if (hits.count() > firstHit + 1) {
          hits.keepEarliestFrom(firstHit);
        }
      }
    }
    odometer.setLeafFreeByPoints(leaf, tree.first(node), end);
  }

  /**
   * Whether all around a leaf is empty; then it is skipped until its points may leave that space.
   */
  private boolean isLeafInEmptySpace(int node, int leaf) {
    double a = tree.x(node);
    double b = tree.y(node);
    double c = tree.z(node);
    double around =
        levels.clearance.at(cellsFrom.x(a, b, c), cellsFrom.y(a, b, c), cellsFrom.z(a, b, c));
    double empty = around - tree.radius(node) * inverseCellMm - roundingCells;
    if (empty <= travel) {
      return false;
    }
    odometer.setLeafFree(leaf, empty);
    return true;
  }

  /** Whether the leg of one point touches no solid. */
  boolean isPointFree(int n, LegHits hits) {
    tested++;
    int before = hits.count();
    if (!(skips && odometer.isPointFree(n, travel))) {
      testLeg(n, hits);
    }
    return hits.count() == before;
  }

  private void testLeg(int n, LegHits hits) {
    looked++;
    double a = tool.x(n);
    double b = tool.y(n);
    double c = tool.z(n);
    if (level[n] != highest) {
      testReduced(n, hits);
      return;
    }
    if (screen.isFree(n)) {
      odometer.setPointFree(n, screen.emptyAround(n) - roundingCells);
      return;
    }
    double x = cellsFrom.x(a, b, c);
    double y = cellsFrom.y(a, b, c);
    double z = cellsFrom.z(a, b, c);
    BitCube cube = levels.cubes[highest];
    double empty = skips ? levels.emptyAround(x, y, z) - roundingCells : 0;
    odometer.setPointFree(n, empty);
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

  private void testReduced(int n, LegHits hits) {
    int at = level[n];
    levels.inCells(tool.point(n, position), from, at, position);
    ray.from(position.x, position.y, position.z);
    levels.inCells(tool.point(n, position), to, at, position);
    ray.to(position.x, position.y, position.z);
    odometer.forgetPoint(n);
    cast(n, at, ray, hits);
  }

  private void cast(int n, int atLevel, Ray leg, LegHits hits) {
    if (!caster.cast(levels.cubes[atLevel], leg, hit)) {
      return;
    }
    odometer.forgetPoint(n);
    hits.add(n, hit.t);
    if (hit.axis != RayHit.NO_AXIS) {
      hits.setFace(leg, hit, levels.cellMm(atLevel, hit.axis));
    }
  }

  /**
   * Raises the levels of points that have moved away from the body. Tests a bounded number of
   * points, and returns it; the next call goes on with the others.
   */
  int raiseLevels(int most) {
    if (reducedCount > 0) {
      catchUp();
    }
    int n = 0;
    for (; n < most && reducedCount > 0; n++) {
      raiseNext = raiseNext + 1 < tool.count() ? raiseNext + 1 : 0;
      int now = level[raiseNext];
      if (now < highest
          && !levels.touches(tool.point(raiseNext, position), from, now + 1, caster)) {
        level[raiseNext]++;
        odometer.forgetPoint(raiseNext);
        odometer.forgetLeaf(tree.leafOfPoint(raiseNext));
        reducedCount -= now + 1 == highest ? 1 : 0;
      }
    }
    return n;
  }
}
