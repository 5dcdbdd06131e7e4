package org.palpate.host;

import java.util.ArrayList;
import java.util.List;
import org.palpate.collision.CollisionScene;
import org.palpate.device.HandTarget;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.Ray;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.RayHit;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Finds the points that a simulated hand can press: where rays from all directions first meet a
 * solid.
 */
public final class HandTargetFinder {
  private static final int RAYS = 512;

  /** Angle between successive directions of a spiral that covers the sphere evenly, rad. */
  private static final double GOLDEN_ANGLE = StrictMath.PI * (3 - Math.sqrt(5));

  private HandTargetFinder() {}

  /**
   * {@return the target in world mm; the box of the whole grid if no voxel is solid}
   *
   * @param volume the segments, on one grid
   */
  public static HandTarget of(SegmentedVolume volume) {
    VoxelGrid grid = volume.grid();
    IntBox box = solidBox(volume);
    List<BitCube> cubes = volume.segments().stream().map(Segment::bits).toList();
    Vec3 lowMm = new Vec3(Double.MAX_VALUE, Double.MAX_VALUE, Double.MAX_VALUE);
    Vec3 highMm = new Vec3(-Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE);
    for (int corner = 0; corner < 8; corner++) {
      includeCorner(box, corner, grid, lowMm, highMm);
    }
    Vec3 spacing = grid.spacingMm();
    double voxelMm = Math.min(spacing.x, Math.min(spacing.y, spacing.z));
    return new HandTarget(lowMm, highMm, voxelMm, surface(new CollisionScene(cubes), box, grid));
  }

  private static IntBox solidBox(SegmentedVolume volume) {
    IntBox box = new IntBox();
    for (Segment segment : volume.segments()) {
      box.include(segment.bits().bounds());
    }
    if (box.isEmpty()) {
      VoxelGrid grid = volume.grid();
      box.include(0, 0, 0);
      box.include(grid.sizeX() - 1, grid.sizeY() - 1, grid.sizeZ() - 1);
    }
    return box;
  }

  private static void includeCorner(
      IntBox box, int corner, VoxelGrid grid, Vec3 lowMm, Vec3 highMm) {
    Vec3 p =
        new Vec3(
            (corner & 1) == 0 ? box.lowX : box.highX + 1,
            (corner & 2) == 0 ? box.lowY : box.highY + 1,
            (corner & 4) == 0 ? box.lowZ : box.highZ + 1);
    grid.gridToWorld(p, p);
    lowMm.set(Math.min(lowMm.x, p.x), Math.min(lowMm.y, p.y), Math.min(lowMm.z, p.z));
    highMm.set(Math.max(highMm.x, p.x), Math.max(highMm.y, p.y), Math.max(highMm.z, p.z));
  }

  private static List<Vec3> surface(CollisionScene scene, IntBox box, VoxelGrid grid) {
    double x = (box.lowX + box.highX + 1) / 2.0;
    double y = (box.lowY + box.highY + 1) / 2.0;
    double z = (box.lowZ + box.highZ + 1) / 2.0;
    double reach = 1 + Math.max(x - box.lowX, Math.max(y - box.lowY, z - box.lowZ)) * 2;
    RayCaster caster = new ExactRayCaster();
    Ray ray = new Ray().to(x, y, z);
    RayHit hit = new RayHit();
    List<Vec3> points = new ArrayList<>();
    for (int n = 0; n < RAYS; n++) {
      double up = 1 - (2 * n + 1.0) / RAYS;
      double out = Math.sqrt(1 - up * up);
      double dx = reach * out * StrictMath.cos(n * GOLDEN_ANGLE);
      double dy = reach * out * StrictMath.sin(n * GOLDEN_ANGLE);
      double dz = reach * up;
      if (scene.cast(caster, ray.from(x + dx, y + dy, z + dz), hit)) {
        double remaining = 1 - hit.t;
        Vec3 point = new Vec3(x + remaining * dx, y + remaining * dy, z + remaining * dz);
        points.add(grid.gridToWorld(point, point));
      }
    }
    return points;
  }
}
