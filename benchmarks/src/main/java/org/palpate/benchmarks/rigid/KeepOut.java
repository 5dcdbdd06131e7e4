package org.palpate.benchmarks.rigid;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.GrownSolids;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;
import org.palpate.rigid.Clearance;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * The cells that the sample points of a tool must avoid around the only body of a scene of unit
 * voxels, searched point by point without culling. One thread.
 */
final class KeepOut {
  private static final int MOST_PROJECTIONS = 60;

  private final Body body;
  private final RigidTool tool;
  private final BitCube cells;
  private final GrownSolids grown;
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 position = new Vec3();
  private final Ray ray = new Ray();
  private final RayHit hit = new RayHit();
  private final ExactRayCaster caster = new ExactRayCaster();

  KeepOut(BodyScene scene, RigidTool tool, Clearance clearance) {
    body = scene.body(0);
    this.tool = tool;
    grown =
        clearance.growthMm() == 0
            ? null
            : new GrownSolids(
                body.bits(), body.metric(), clearance.growthMm(), clearance.longestCellMm());
    cells = grown == null ? body.bits() : grown.cells();
  }

  /** Whether no sample point lies in a cell. */
  boolean isFree(Pose pose) {
    body.toolToGrid(pose, to);
    for (int point = 0; point < tool.count(); point++) {
      Vec3 at = toCells(to, point);
      if (cells.get((int) Math.floor(at.x), (int) Math.floor(at.y), (int) Math.floor(at.z))) {
        return false;
      }
    }
    return true;
  }

  /** Whether no leg of a sample point between two poses touches a cell. */
  boolean isFree(Pose start, Pose end) {
    body.toolToGrid(start, from);
    body.toolToGrid(end, to);
    for (int point = 0; point < tool.count(); point++) {
      Vec3 at = toCells(from, point);
      ray.from(at.x, at.y, at.z);
      at = toCells(to, point);
      if (caster.cast(cells, ray.to(at.x, at.y, at.z), hit)) {
        return false;
      }
    }
    return true;
  }

  private Vec3 toCells(AffineMap map, int point) {
    map.transform(tool.point(point, position), position);
    return grown == null
        ? position
        : position.set(
            grown.toCells(position.x, 0),
            grown.toCells(position.y, 1),
            grown.toCells(position.z, 2));
  }

  /**
   * Returns the distance of the nearest cell from a line, mm.
   *
   * @param axis unit
   */
  double distanceFromLineMm(Vec3 origin, Vec3 axis) {
    double parts = grown == null ? 1 : grown.parts(0);
    double pad = grown == null ? 0 : grown.padVoxels();
    double half = Math.sqrt(0.75) / parts;
    double least = Double.POSITIVE_INFINITY;
    for (int k = 0; k < cells.sizeZ(); k++) {
      for (int j = 0; j < cells.sizeY(); j++) {
        for (int i = 0; i < cells.sizeX(); i++) {
          if (cells.get(i, j, k)) {
            Vec3 low = new Vec3(i / parts - pad, j / parts - pad, k / parts - pad);
            Vec3 centre = low.add(new Vec3(0.5 / parts, 0.5 / parts, 0.5 / parts), new Vec3());
            if (onLine(centre, origin, axis).sub(centre, centre).length() - half < least) {
              least = Math.min(least, distanceMm(low, 1 / parts, origin, axis));
            }
          }
        }
      }
    }
    return least;
  }

  /** Returns the distance between a cube and a line by projecting onto each in turn. */
  private static double distanceMm(Vec3 low, double edge, Vec3 origin, Vec3 axis) {
    Vec3 inside = new Vec3(low.x, low.y, low.z);
    Vec3 line = onLine(inside, origin, axis);
    for (int n = 0; n < MOST_PROJECTIONS; n++) {
      for (int c = 0; c < 3; c++) {
        inside.set(c, Math.max(low.get(c), Math.min(low.get(c) + edge, line.get(c))));
      }
      line = onLine(inside, origin, axis);
    }
    return line.sub(inside, line).length();
  }

  private static Vec3 onLine(Vec3 point, Vec3 origin, Vec3 axis) {
    double along = point.sub(origin, new Vec3()).dot(axis);
    return axis.mul(along, new Vec3()).add(origin, new Vec3());
  }
}
