package org.palpate.rigid;

import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;

/**
 * Judges by brute force whether a tool that was made of unit voxels overlaps a body: every voxel of
 * the tool, as a turned box, against every solid voxel of the body near it, by separating axes.
 * Sees neither sample points nor clearances.
 */
final class OverlapJudge {
  /** Boxes whose interiors share less than this along some axis only touch, mm. */
  private static final double TOUCHING_MM = 1e-9;

  private final BitCube toolBits;
  private final Vec3 reference;
  private final AffineMap map = new AffineMap();
  private final Vec3 centre = new Vec3();
  private final double[][] toolAxes = new double[3][3];
  private double leastGapMm = Double.POSITIVE_INFINITY;

  /**
   * Creates a judge.
   *
   * @param toolBits the voxels, of 1 mm, that the tool was made of
   */
  OverlapJudge(BitCube toolBits, RigidTool tool) {
    this.toolBits = toolBits;
    reference = tool.referenceMm(new Vec3());
  }

  /** Returns a lower bound of the least gap between voxels that was seen so far, mm. */
  double leastGapMm() {
    return leastGapMm;
  }

  /** Whether the tool at a pose overlaps any body of a scene. */
  boolean overlaps(BodyScene scene, Pose pose) {
    boolean any = false;
    for (int b = 0; b < scene.count(); b++) {
      any |= overlaps(scene.body(b), pose);
    }
    return any;
  }

  private boolean overlaps(Body body, Pose pose) {
    body.toolToGrid(pose, map);
    Vec3 spacing = body.grid().spacingMm();
    setToolAxes(spacing);
    boolean any = false;
    for (int n = 0; n < toolBits.sizeX() * toolBits.sizeY() * toolBits.sizeZ(); n++) {
      int i = n % toolBits.sizeX();
      int j = n / toolBits.sizeX() % toolBits.sizeY();
      int k = n / toolBits.sizeX() / toolBits.sizeY();
      if (toolBits.get(i, j, k)) {
        centre.set(i + 0.5, j + 0.5, k + 0.5).sub(reference, centre);
        map.transform(centre, centre);
        any |= meetsAny(body.bits(), spacing);
      }
    }
    return any;
  }

  /** Writes the axes of the tool's voxels, unit, along the axes of the body's grid in mm. */
  private void setToolAxes(Vec3 spacing) {
    double[][] rows = {
      {map.mXX, map.mXY, map.mXZ}, {map.mYX, map.mYY, map.mYZ}, {map.mZX, map.mZY, map.mZZ}
    };
    for (int axis = 0; axis < 3; axis++) {
      for (int c = 0; c < 3; c++) {
        toolAxes[axis][c] = rows[c][axis] * spacing.get(c);
      }
    }
  }

  private boolean meetsAny(BitCube bits, Vec3 spacing) {
    double reachMm = 1.8;
    boolean any = false;
    for (int k = low(centre.z, reachMm / spacing.z); k <= centre.z + reachMm / spacing.z; k++) {
      for (int j = low(centre.y, reachMm / spacing.y); j <= centre.y + reachMm / spacing.y; j++) {
        for (int i = low(centre.x, reachMm / spacing.x); i <= centre.x + reachMm / spacing.x; i++) {
          if (bits.get(i, j, k)) {
            double gap = gapMm(i, j, k, spacing);
            leastGapMm = Math.min(leastGapMm, gap);
            any |= gap < -TOUCHING_MM;
          }
        }
      }
    }
    return any;
  }

  private static int low(double centreVoxels, double reachVoxels) {
    return (int) Math.floor(centreVoxels - reachVoxels) - 1;
  }

  /** Returns the widest gap over the 15 directions that can separate two boxes. */
  private double gapMm(int i, int j, int k, Vec3 spacing) {
    double[] between = {
      (centre.x - i - 0.5) * spacing.x,
      (centre.y - j - 0.5) * spacing.y,
      (centre.z - k - 0.5) * spacing.z
    };
    double widest = Double.NEGATIVE_INFINITY;
    for (int a = 0; a < 3; a++) {
      double[] own = new double[3];
      own[a] = 1;
      widest = Math.max(widest, gapAlong(own, between, spacing));
      widest = Math.max(widest, gapAlong(toolAxes[a], between, spacing));
      for (int b = 0; b < 3; b++) {
        widest = Math.max(widest, gapAlong(cross(own, toolAxes[b]), between, spacing));
      }
    }
    return widest;
  }

  private double gapAlong(double[] direction, double[] between, Vec3 spacing) {
    double length = Math.sqrt(dot(direction, direction));
    if (length < 1e-9) {
      return Double.NEGATIVE_INFINITY;
    }
    double reach = 0;
    for (int c = 0; c < 3; c++) {
      reach += Math.abs(direction[c]) * spacing.get(c) / 2;
      reach += Math.abs(dot(direction, toolAxes[c])) / 2;
    }
    return (Math.abs(dot(direction, between)) - reach) / length;
  }

  private static double dot(double[] a, double[] b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double[] cross(double[] a, double[] b) {
    return new double[] {
      a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]
    };
  }
}
