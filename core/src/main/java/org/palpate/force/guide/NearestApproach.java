package org.palpate.force.guide;

import java.util.OptionalDouble;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.SphereTree;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Finds how near a tool came to a segment at rest, and in which frame. The frame and the sample
 * point are found by {@link SegmentDistance}, within its reach; the distance of that point is then
 * computed without interpolation.
 *
 * <p>Writer: the haptic thread, which notes each frame and allocates nothing. Read it before the
 * first frame or after the last.
 */
public final class NearestApproach {
  /** Interpolated distances may grow this much faster than the position: the root of 3. */
  private static final double STEEPEST = 1.75;

  private final String segment;
  private final double marginMm;
  private final BitCube solids;
  private final SegmentDistance distances;
  private final double reachMm;
  private final AffineMap restToGrid = new AffineMap();
  private final AffineMap toolToGrid = new AffineMap();
  private final AffineMap scratch = new AffineMap();
  private final Vec3 nearestGrid = new Vec3();
  private double nearestMm;
  private long frame = -1;

  /**
   * Creates a record without frames.
   *
   * @param segment the name of the segment
   * @param marginMm the margin that the tool keeps, mm
   * @param solids its voxels, which do not change
   * @param grid the grid of the segment at rest
   * @param reachMm the greatest distance that is noted, mm, positive
   */
  public NearestApproach(
      String segment, double marginMm, BitCube solids, VoxelGrid grid, double reachMm) {
    this.segment = segment;
    this.marginMm = marginMm;
    this.solids = solids;
    this.reachMm = reachMm;
    distances = new SegmentDistance(solids, grid, reachMm);
    nearestMm = reachMm;
    grid.worldToGrid(restToGrid);
  }

  /** {@return the name of the segment} */
  public String segment() {
    return segment;
  }

  /** {@return the margin that the tool keeps, mm} */
  public double marginMm() {
    return marginMm;
  }

  /**
   * Notes where an interaction point was at the end of a frame.
   *
   * @param grid the position, grid coordinates of the segment
   * @param frameNumber the number of the frame, from 0
   */
  public void notePoint(Vec3 grid, long frameNumber) {
    note(grid.x, grid.y, grid.z, frameNumber);
  }

  /**
   * Notes where a rigid tool was at the end of a frame. Cost: a few nodes of its tree, unless it
   * comes nearer than before.
   *
   * @param tool the sample points of the tool
   * @param pose from the frame of the tool to the world, mm
   * @param frameNumber the number of the frame, from 0
   */
  public void noteTool(RigidTool tool, Pose pose, long frameNumber) {
    restToGrid.multiply(scratch.set(pose), toolToGrid);
    SphereTree tree = tool.tree();
    int node = 0;
    while (node < tree.nodes()) {
      double mm = distance(tree.x(node), tree.y(node), tree.z(node));
      if (mm - STEEPEST * tree.radius(node) >= nearestMm) {
        node = tree.skip(node);
        continue;
      }
      for (int point = tree.first(node); tree.isLeaf(node) && point < tree.end(node); point++) {
        double a = tool.x(point);
        double b = tool.y(point);
        double c = tool.z(point);
        note(toolToGrid.x(a, b, c), toolToGrid.y(a, b, c), toolToGrid.z(a, b, c), frameNumber);
      }
      node++;
    }
  }

  private double distance(double a, double b, double c) {
    return distances.at(toolToGrid.x(a, b, c), toolToGrid.y(a, b, c), toolToGrid.z(a, b, c));
  }

  private void note(double x, double y, double z, long frameNumber) {
    double mm = distances.at(x, y, z);
    if (mm < nearestMm) {
      nearestMm = mm;
      nearestGrid.set(x, y, z);
      frame = frameNumber;
    }
  }

  /**
   * {@return the number of the frame in which the tool was nearest; -1 if it never was in reach}
   */
  public long frame() {
    return frame;
  }

  /**
   * {@return the distance between the sample point that came nearest and the nearest voxel, a
   * closed box, mm; empty if no point ever was in reach}
   */
  public OptionalDouble nearestMm() {
    if (frame < 0) {
      return OptionalDouble.empty();
    }
    GridMetric metric = distances.grid().metric();
    double least = Double.POSITIVE_INFINITY;
    IntBox box = solids.bounds();
    for (int k = box.lowZ; k <= box.highZ; k++) {
      double z = gap(nearestGrid.z, k) * metric.spacingZ();
      for (int j = box.lowY; j <= box.highY && z <= 2 * reachMm; j++) {
        double y = gap(nearestGrid.y, j) * metric.spacingY();
        for (int i = box.lowX; i <= box.highX && y <= 2 * reachMm; i++) {
          double x = gap(nearestGrid.x, i) * metric.spacingX();
          double square = x * x + y * y + z * z;
          if (square < least && solids.get(i, j, k)) {
            least = square;
          }
        }
      }
    }
    return OptionalDouble.of(Math.sqrt(least));
  }

  private static double gap(double coordinate, int voxel) {
    return Math.max(0, Math.max(voxel - coordinate, coordinate - (voxel + 1)));
  }
}
