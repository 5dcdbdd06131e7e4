package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.body.BrickClearance;
import org.palpate.body.EmptyCubes;
import org.palpate.body.GrownSolids;
import org.palpate.collision.CollisionDevice;
import org.palpate.collision.DeviceVoxels;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;

/**
 * The solids of one body that the sample points of a tool must not touch, by levels of clearance.
 * Level 0 is the voxels. With a clearance, the levels above are grown solids, each of which
 * contains the level below. Most points keep the highest level. A point that starts nearer keeps
 * the highest level that it does not touch.
 *
 * <p>Level 0 is in the grid coordinates of the body, in which legs are recorded. The others are in
 * the coordinates of their cells, whose rounding is far below the growth. Haptic thread only.
 */
final class ClearanceLevels {
  final Body body;

  /** The cubes by level. */
  final BitCube[] cubes;

  /** The level of points that do not start nearer. */
  final int highest;

  /** Lower bounds of the distance to the cube of the highest level, in its cells. */
  final BrickClearance clearance;

  /** Empty cubes among the cells of the highest level. */
  private final EmptyCubes emptyCubes;

  /** The cube of the highest level on the device that judges legs. */
  final DeviceVoxels onDevice;

  /** The shortest edge of a cell of the highest level, mm. */
  final double cellMm;

  private final double growthMm;
  private final GrownSolids[] grown;
  private final AffineMap pointToCells = new AffineMap();
  private final Vec3 inCells = new Vec3();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private long editsSeen;

  /** Grows the solids of a body by the clearance of a tool, and by parts of it. */
  ClearanceLevels(Body body, Clearance clearanceOfTool, CollisionDevice device) {
    this.body = body;
    growthMm = clearanceOfTool.growthMm();
    GrownSolids whole = growthMm > 0 ? grown(body, clearanceOfTool, growthMm) : null;
    highest = whole == null ? 0 : levels(clearanceOfTool, whole);
    grown = new GrownSolids[highest + 1];
    cubes = new BitCube[highest + 1];
    cubes[0] = body.bits();
    for (int level = 1; level <= highest; level++) {
      grown[level] =
          level == highest ? whole : grown(body, clearanceOfTool, growthMm * level / highest);
      cubes[level] = grown[level].cells();
    }
    clearance = highest == 0 ? body.clearance() : new BrickClearance(cubes[highest]);
    emptyCubes = new EmptyCubes(cubes[highest]);
    onDevice = device.keep(cubes[highest]);
    cellMm = Math.min(cellMm(highest, 0), Math.min(cellMm(highest, 1), cellMm(highest, 2)));
    editsSeen = body.edits();
  }

  private static GrownSolids grown(Body body, Clearance clearance, double growthMm) {
    return new GrownSolids(body.bits(), body.metric(), growthMm, clearance.longestCellMm());
  }

  /**
   * Returns the number of levels; 1 if cells are so large that parts of the growth would be alike.
   */
  private static int levels(Clearance clearance, GrownSolids whole) {
    double cellMm = Math.min(whole.cellMm(0), Math.min(whole.cellMm(1), whole.cellMm(2)));
    return clearance.growthMm() <= cellMm ? 1 : Math.max(1, clearance.levels());
  }

  /** Returns the length by which the solids of the highest level are grown, mm. */
  double growthMm() {
    return growthMm;
  }

  /** Returns the edge of a cell of a level along an axis, mm: 0 is x. */
  double cellMm(int level, int axis) {
    return level == 0 ? body.grid().spacingMm().get(axis) : grown[level].cellMm(axis);
  }

  /** Returns the edges of a cell of a level, mm. */
  Vec3 cellMm(int level) {
    return new Vec3(cellMm(level, 0), cellMm(level, 1), cellMm(level, 2));
  }

  private int pad(int level) {
    return level == 0 ? 0 : grown[level].padVoxels();
  }

  /**
   * Returns the length by which the cells of a level reach beyond a voxel along a direction, mm.
   *
   * @param normal unit, along the axes of the body's grid in mm
   */
  double reachMm(int level, Vec3 normal) {
    return level == 0 ? 0 : grown[level].reachMm(normal);
  }

  /** Writes the map to the cells of a level that follows from a map to the body's grid. */
  AffineMap toCells(AffineMap toGrid, int level, AffineMap dest) {
    dest.set(toGrid);
    if (level == 0) {
      return dest;
    }
    GrownSolids cells = grown[level];
    double scaleX = cells.parts(0);
    double scaleY = cells.parts(1);
    double scaleZ = cells.parts(2);
    dest.mXX *= scaleX;
    dest.mXY *= scaleX;
    dest.mXZ *= scaleX;
    dest.mYX *= scaleY;
    dest.mYY *= scaleY;
    dest.mYZ *= scaleY;
    dest.mZX *= scaleZ;
    dest.mZY *= scaleZ;
    dest.mZZ *= scaleZ;
    dest.offsetX = cells.toCells(toGrid.offsetX, 0);
    dest.offsetY = cells.toCells(toGrid.offsetY, 1);
    dest.offsetZ = cells.toCells(toGrid.offsetZ, 2);
    return dest;
  }

  /** Returns half the edge of an empty cube around a point, in cells of the highest level. */
  double emptyAround(double x, double y, double z) {
    double near = emptyCubes.around(x, y, z);
    return near >= 2 ? Math.max(near, clearance.at(x, y, z)) : near;
  }

  /** Writes the place of a point in the cells of a level; {@code dest} may be the point. */
  Vec3 inCells(Vec3 point, AffineMap toGrid, int level, Vec3 dest) {
    return toCells(toGrid, level, pointToCells).transform(point, dest);
  }

  /**
   * Returns the highest level, up to a limit, that a point does not touch; -1 if it touches all.
   *
   * @param toGrid the map from the frame of the point to the body's grid
   */
  int freeLevel(Vec3 point, AffineMap toGrid, int limit, ExactRayCaster caster) {
    int free = limit;
    while (free >= 0 && touches(point, toGrid, free, caster)) {
      free--;
    }
    return free;
  }

  /** Whether a point touches a level. */
  boolean touches(Vec3 point, AffineMap toGrid, int level, ExactRayCaster caster) {
    return touchesInCells(inCells(point, toGrid, level, inCells), level, caster);
  }

  /** Whether a place in the cells of a level touches that level. */
  boolean touchesInCells(Vec3 place, int level, ExactRayCaster caster) {
    ray.from(place.x, place.y, place.z).to(place.x, place.y, place.z);
    return caster.cast(cubes[level], ray, hit);
  }

  /** Applies the edits of the body since the last call. Several verifiers may share the levels. */
  void takeEdits() {
    long edits = body.edits();
    if (edits == editsSeen) {
      return;
    }
    for (long edit = Math.max(editsSeen, body.oldestEdit() - 1); edit < edits; edit++) {
      updateGrown(body.change(edit));
    }
    emptyCubes.forget();
    editsSeen = edits;
  }

  /** Whether {@link #takeEdits} has seen all edits of the body. */
  boolean areCurrent() {
    return body.edits() == editsSeen;
  }

  private void updateGrown(IntBox box) {
    if (highest == 0) {
      onDevice.voxelsChanged(box);
    }
    for (int level = 1; level <= highest; level++) {
      IntBox cells = grown[level].update(box);
      if (level == highest) {
        clearance.solidsAdded(cells);
        onDevice.voxelsChanged(cells);
      }
    }
  }

  /** Returns the grown solids of a level above 0. */
  GrownSolids grown(int level) {
    return grown[level];
  }

  /** Returns the number of voxels by which the highest level reaches beyond a solid voxel. */
  int reachVoxels() {
    return pad(highest);
  }
}
