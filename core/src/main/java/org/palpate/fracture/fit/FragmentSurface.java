package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.fracture.PartialVoxels;
import org.palpate.fracture.Residual;
import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;
import org.palpate.volume.fracture.PosedBits;

/**
 * Points on the smoothed surface of a fragment at rest, about one for each voxel of its rim.
 *
 * @param points where they lie, world mm
 * @param normals the outward unit normal of each
 * @param areaMm2 the area that a point stands for
 * @param centroid the mean of the voxel centres, world mm
 * @param leverMm the rms distance of the points from there
 */
record FragmentSurface(
    List<Vec3> points, List<Vec3> normals, double areaMm2, Vec3 centroid, double leverMm) {
  /** The standard deviation of the smoothing, voxels. */
  static final double SIGMA = 0.6;

  /** The most points that are kept; of more, every second, third and so on. */
  private static final int MOST_POINTS = 60_000;

  /** The largest distance of the surface from the centre of a rim voxel, longest voxel edges. */
  private static final double MOST_EDGES = 1.5;

  /** Finds the surface of a fragment by its bits; some 5 us for each point. */
  static FragmentSurface of(BitCube bits, VoxelGrid grid) {
    return of(bits, grid, Optional.empty());
  }

  /**
   * Finds the surface of a fragment; some 5 us for each point.
   *
   * @param partial how full the voxels at the surface are; if empty, only the bits count
   */
  static FragmentSurface of(BitCube bits, VoxelGrid grid, Optional<PartialVoxels> partial) {
    long[] rim = new long[1];
    bits.forEachRimVoxel((i, j, k) -> rim[0]++);
    long stride = 1 + (rim[0] - 1) / MOST_POINTS;
    Vec3 spacing = grid.spacingMm();
    double edgeMm = edgeMm(grid);
    double mostMm = MOST_EDGES * Math.max(spacing.x, Math.max(spacing.y, spacing.z));
    PosedBits atRest = new PosedBits(bits, grid, new Pose());
    SmoothedBits smoothed = new SmoothedBits(atRest, partial, SIGMA);
    List<Vec3> points = new ArrayList<>();
    List<Vec3> normals = new ArrayList<>();
    rim[0] = 0;
    bits.forEachRimVoxel(
        (i, j, k) -> {
          if (rim[0]++ % stride == 0) {
            Vec3 centre = grid.gridToWorld(new Vec3(i + 0.5, j + 0.5, k + 0.5), new Vec3());
            Vec3 normal = new Vec3();
            Vec3 point = new Vec3();
            smoothed.occupancy(centre, normal);
            if (smoothed.surface(centre, normal, mostMm, point)) {
              smoothed.occupancy(point, normal);
              points.add(point);
              normals.add(normal);
            }
          }
        });
    Vec3 centroid = Residual.centroid(atRest);
    return new FragmentSurface(
        points,
        normals,
        stride * edgeMm * edgeMm,
        centroid,
        Math.max(edgeMm, rmsDistanceMm(points, centroid)));
  }

  /** Returns the edge of a cube as large as a voxel of a grid, mm. */
  static double edgeMm(VoxelGrid grid) {
    Vec3 spacing = grid.spacingMm();
    return Math.cbrt(spacing.x * spacing.y * spacing.z);
  }

  private static double rmsDistanceMm(List<Vec3> points, Vec3 from) {
    double sum = 0;
    Vec3 offset = new Vec3();
    for (Vec3 point : points) {
      point.sub(from, offset);
      sum += offset.dot(offset);
    }
    return Math.sqrt(sum / Math.max(1, points.size()));
  }
}
