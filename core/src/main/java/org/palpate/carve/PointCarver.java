package org.palpate.carve;

import java.util.Arrays;
import org.palpate.collision.CollisionScene;
import org.palpate.edit.VoxelWriter;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayHit;

/**
 * Cuts with an interaction point: removes the first voxel on the straight line to the device, from
 * every segment that has it.
 *
 * <p>Haptic thread only; allocates nothing. Grid coordinates.
 */
public final class PointCarver {
  /** The distance from the point within which a voxel is looked for, shortest voxel edges. */
  private static final double REACH_EDGES = 2;

  private final CollisionScene scene;
  private final GridMetric metric;
  private final VoxelCutter cutter;
  private final ExactRayCaster caster = new ExactRayCaster();
  private final Ray line = new Ray();
  private final RayHit hit = new RayHit();

  /**
   * Creates a carver.
   *
   * @param settings the rate, and what must not be cut
   * @param scene the voxels of all segments, on one grid
   * @param metric the edges of a voxel of that grid
   * @param segments number of segments of the scene
   * @param out removes the voxels
   */
  public PointCarver(
      CarveSettings settings,
      CollisionScene scene,
      GridMetric metric,
      int segments,
      VoxelWriter out) {
    this.scene = scene;
    this.metric = metric;
    double[] voxelMm3 = new double[segments];
    Arrays.fill(voxelMm3, metric.spacingX() * metric.spacingY() * metric.spacingZ());
    cutter = new VoxelCutter(settings, voxelMm3, out);
  }

  /**
   * Cuts in a frame, before the point moves.
   *
   * @param point the interaction point, which touches no solid
   * @param device the device position, finite
   * @param forceNewton the force on the hand in the last frame, N
   * @param nanos the time since that frame
   * @return whether a voxel was removed
   */
  public boolean carve(Vec3 point, Vec3 device, double forceNewton, long nanos) {
    if (!cutter.begin(forceNewton, nanos)) {
      return false;
    }
    double distanceMm = metric.distance(point.x, point.y, point.z, device.x, device.y, device.z);
    double reachMm = REACH_EDGES * metric.shortestEdgeMm();
    double fraction = distanceMm > reachMm ? reachMm / distanceMm : 1;
    line.from(point.x, point.y, point.z);
    line.to(
        point.x + fraction * (device.x - point.x),
        point.y + fraction * (device.y - point.y),
        point.z + fraction * (device.z - point.z));
    if (scene.cast(caster, line, hit)) {
      cutAll();
    }
    return cutter.removed() > 0;
  }

  /** Removes the voxel of the hit from every segment that has it, until one keeps it. */
  private void cutAll() {
    int last = -1;
    int segment = scene.objectAt(hit.i, hit.j, hit.k);
    while (segment > last && cutter.cut(segment, hit.i, hit.j, hit.k)) {
      last = segment;
      segment = scene.objectAt(hit.i, hit.j, hit.k);
    }
  }
}
