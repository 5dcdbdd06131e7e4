package org.palpate.rigid;

import java.util.ArrayList;
import java.util.List;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.BoxShape;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Judges by brute force whether a tool that is made of boxes overlaps a body: every box of the
 * tool, turned, against every solid voxel of the body near it, by separating axes. Sees neither
 * sample points nor clearances.
 */
final class OverlapJudge {
  /** Boxes whose interiors share less than this along some axis only touch, mm. */
  private static final double TOUCHING_MM = 1e-9;

  /** Centre and half edges of each box, tool frame, mm. */
  private final List<double[]> boxes = new ArrayList<>();

  /** The directions of the edges of all boxes in the tool frame. */
  private final Vec3[] edges;

  private final AffineMap map = new AffineMap();
  private final Vec3 centre = new Vec3();
  private final double[][] toolAxes = new double[3][3];
  private double[] half;
  private double leastGapMm = Double.POSITIVE_INFINITY;

  /**
   * Creates a judge of a tool of voxels.
   *
   * @param toolBits the voxels that the tool was made of
   */
  OverlapJudge(BitCube toolBits, VoxelGrid grid, RigidTool tool) {
    RigidTransform t = grid.gridMmToWorld();
    edges = new Vec3[] {t.axisX(), t.axisY(), t.axisZ()};
    Vec3 reference = tool.referenceMm(new Vec3());
    Vec3 s = grid.spacingMm();
    for (int n = 0; n < toolBits.sizeX() * toolBits.sizeY() * toolBits.sizeZ(); n++) {
      int i = n % toolBits.sizeX();
      int j = n / toolBits.sizeX() % toolBits.sizeY();
      int k = n / toolBits.sizeX() / toolBits.sizeY();
      if (toolBits.get(i, j, k)) {
        Vec3 c = grid.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
        c.sub(reference, c);
        boxes.add(new double[] {c.x, c.y, c.z, s.x / 2, s.y / 2, s.z / 2});
      }
    }
  }

  /** Creates a judge of a tool of unit voxels. */
  OverlapJudge(BitCube toolBits, RigidTool tool) {
    this(
        toolBits,
        VoxelGrid.ofUnitVoxels(toolBits.sizeX(), toolBits.sizeY(), toolBits.sizeZ()),
        tool);
  }

  /** Creates a judge of a cuboid around the reference point. */
  OverlapJudge(BoxShape box) {
    edges = new Vec3[] {new Vec3(1, 0, 0), new Vec3(0, 1, 0), new Vec3(0, 0, 1)};
    boxes.add(new double[] {0, 0, 0, box.edgeX() / 2, box.edgeY() / 2, box.edgeZ() / 2});
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
    for (double[] box : boxes) {
      map.transform(centre.set(box[0], box[1], box[2]), centre);
      half = new double[] {box[3], box[4], box[5]};
      any |= meetsAny(body.bits(), spacing);
    }
    return any;
  }

  /** Writes the axes of the tool's voxels, unit, along the axes of the body's grid in mm. */
  private void setToolAxes(Vec3 spacing) {
    for (int axis = 0; axis < 3; axis++) {
      Vec3 turned = map.transformDirection(edges[axis], new Vec3());
      for (int c = 0; c < 3; c++) {
        toolAxes[axis][c] = turned.get(c) * spacing.get(c);
      }
    }
  }

  private boolean meetsAny(BitCube bits, Vec3 spacing) {
    double reachMm = Math.sqrt(dot(half, half)) + 0.5;
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
      reach += Math.abs(dot(direction, toolAxes[c])) * half[c];
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
