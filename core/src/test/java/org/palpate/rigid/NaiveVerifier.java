package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.testing.FilteredOracle;

/** Verifies a motion without culling: every leg of every point against every body, exactly. */
final class NaiveVerifier {
  private final BodyScene scene;
  private final RigidTool tool;
  private final FilteredOracle oracle = new FilteredOracle();
  private final AffineMap from = new AffineMap();
  private final AffineMap to = new AffineMap();
  private final Vec3 p = new Vec3();
  private final Ray ray = new Ray();
  private long legs;

  NaiveVerifier(BodyScene scene, RigidTool tool) {
    this.scene = scene;
    this.tool = tool;
  }

  long legs() {
    return legs;
  }

  /** Returns the first leg between two poses that touches a voxel, or null. */
  String fault(Pose start, Pose end) {
    for (int b = 0; b < scene.count(); b++) {
      Body body = scene.body(b);
      body.toolToGrid(start, from);
      body.toolToGrid(end, to);
      for (int n = 0; n < tool.count(); n++) {
        from.transform(tool.point(n, p), p);
        ray.from(p.x, p.y, p.z);
        to.transform(tool.point(n, p), p);
        ray.to(p.x, p.y, p.z);
        legs++;
        if (oracle.touchesAny(body.bits(), ray)) {
          return "body " + b + " point " + n + ": " + ray;
        }
      }
    }
    return null;
  }

  /** Whether a motion is free of the cells of given levels, a level for each point and body. */
  boolean isFreeOfLevels(Pose start, Pose end, MoverVerifier levels) {
    for (int b = 0; b < scene.count(); b++) {
      BodyVerifier verifier = levels.pair(b);
      AffineMap cells = new AffineMap();
      for (int n = 0; n < tool.count(); n++) {
        int level = verifier.level(n);
        verifier.levels.toCells(scene.body(b).toolToGrid(start, from), level, cells);
        cells.transform(tool.point(n, p), p);
        ray.from(p.x, p.y, p.z);
        verifier.levels.toCells(scene.body(b).toolToGrid(end, to), level, cells);
        cells.transform(tool.point(n, p), p);
        ray.to(p.x, p.y, p.z);
        if (oracle.touchesAny(verifier.levels.cubes[level], ray)) {
          return false;
        }
      }
    }
    return true;
  }
}
