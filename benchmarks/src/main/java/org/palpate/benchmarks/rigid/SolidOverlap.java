package org.palpate.benchmarks.rigid;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;

/**
 * Judges by brute force whether a ball or a cuboid overlaps a body: it compares the shape with
 * every solid voxel. It sees neither sample points nor clearances. One thread.
 */
final class SolidOverlap {
  /** Shapes that share less than this only touch, mm. */
  private static final double TOUCHING_MM = 1e-9;

  /** The cross product of parallel edges is no direction. */
  private static final double LEAST_LENGTH = 1e-9;

  private static final Vec3[] UNITS = {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};

  private final double ballRadiusMm;
  private final double[] half;
  private final AffineMap map = new AffineMap();
  private final Vec3 centre = new Vec3();
  private final Vec3 between = new Vec3();
  private final Vec3[] axes = {new Vec3(), new Vec3(), new Vec3()};
  private final Vec3 direction = new Vec3();

  private SolidOverlap(double ballRadiusMm, double[] half) {
    this.ballRadiusMm = ballRadiusMm;
    this.half = half;
  }

  /** Returns a judge of a ball around the reference point. */
  static SolidOverlap ofBall(double radiusMm) {
    return new SolidOverlap(radiusMm, new double[3]);
  }

  /** Returns a judge of a cuboid around the reference point. */
  static SolidOverlap ofBox(BoxShape box) {
    return new SolidOverlap(0, new double[] {box.edgeX() / 2, box.edgeY() / 2, box.edgeZ() / 2});
  }

  /** Whether the shape at a pose overlaps any body. */
  boolean overlaps(BodyScene bodies, Pose pose) {
    for (int n = 0; n < bodies.count(); n++) {
      if (overlaps(bodies.body(n), pose)) {
        return true;
      }
    }
    return false;
  }

  private boolean overlaps(Body body, Pose pose) {
    Vec3 spacing = body.grid().spacingMm();
    toGridMm(body, pose, spacing);
    IntBox box = body.bits().bounds();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      for (int j = box.lowY; j <= box.highY; j++) {
        for (int i = box.lowX; i <= box.highX; i++) {
          between.set(
              centre.x - (i + 0.5) * spacing.x,
              centre.y - (j + 0.5) * spacing.y,
              centre.z - (k + 0.5) * spacing.z);
          if (body.bits().get(i, j, k) && meets(spacing)) {
            return true;
          }
        }
      }
    }
    return false;
  }

  /** Writes the shape's centre and axes along the axes of the grid, mm. */
  private void toGridMm(Body body, Pose pose, Vec3 spacing) {
    body.toolToGrid(pose, map);
    map.transform(centre.set(0, 0, 0), centre);
    scale(centre, spacing);
    for (int n = 0; n < 3; n++) {
      axes[n].set(UNITS[n]);
      scale(map.transformDirection(axes[n], axes[n]), spacing);
    }
  }

  private static void scale(Vec3 v, Vec3 by) {
    v.set(v.x * by.x, v.y * by.y, v.z * by.z);
  }

  private boolean meets(Vec3 spacing) {
    return ballRadiusMm > 0 ? ballMeets(spacing) : !isSeparate(spacing);
  }

  private boolean ballMeets(Vec3 spacing) {
    double x = Math.max(0, Math.abs(between.x) - spacing.x / 2);
    double y = Math.max(0, Math.abs(between.y) - spacing.y / 2);
    double z = Math.max(0, Math.abs(between.z) - spacing.z / 2);
    return Math.sqrt(x * x + y * y + z * z) < ballRadiusMm - TOUCHING_MM;
  }

  /** Whether one of the 15 directions that can separate two cuboids does. */
  private boolean isSeparate(Vec3 spacing) {
    for (int a = 0; a < 3; a++) {
      if (separates(spacing, UNITS[a]) || separates(spacing, axes[a])) {
        return true;
      }
      for (int b = 0; b < 3; b++) {
        if (separates(spacing, UNITS[b].cross(axes[a], direction))) {
          return true;
        }
      }
    }
    return false;
  }

  private boolean separates(Vec3 spacing, Vec3 along) {
    double reach = 0;
    for (int c = 0; c < 3; c++) {
      reach += Math.abs(along.get(c)) * spacing.get(c) / 2 + Math.abs(along.dot(axes[c])) * half[c];
    }
    double length = along.length();
    return length > LEAST_LENGTH && Math.abs(along.dot(between)) - reach > -TOUCHING_MM * length;
  }
}
