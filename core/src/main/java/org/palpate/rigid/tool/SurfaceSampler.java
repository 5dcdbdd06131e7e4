package org.palpate.rigid.tool;

import java.util.Arrays;
import org.palpate.geometry.Vec3;

/**
 * Samples the surface of a mesh evenly. It cuts the triangles into small pieces, and adds the
 * centre of a piece as a sample unless an earlier sample is near. Each point of the surface then
 * lies within the cover radius of a sample. One thread.
 */
final class SurfaceSampler {
  /** Pieces reach at most this part of the cover radius from their centres. */
  private static final double PIECE = 0.15;

  private final double nearMm;
  private final double squaredNearMm2;
  private final PiecewiseSurface pieces;
  private final PointList points = new PointList();
  private final Vec3 centre = new Vec3();

  /** The last sample of each cell of a hash grid, and the sample before each in its cell. */
  private int[] table = new int[1 << 12];

  private int[] before = new int[1 << 11];

  /**
   * Creates a sampler.
   *
   * @param coverRadiusMm the largest distance of a surface point from its nearest sample, mm
   */
  SurfaceSampler(double coverRadiusMm) {
    nearMm = (1 - PIECE) * coverRadiusMm;
    squaredNearMm2 = nearMm * nearMm;
    // No point of a triangle is farther from its centroid than two thirds of a median, which is
    // shorter than the longest edge.
    pieces = new PiecewiseSurface(1.5 * PIECE * coverRadiusMm);
    Arrays.fill(table, -1);
  }

  /** Returns the samples of a mesh. */
  PointList sample(TriangleMesh mesh) {
    Vec3 a = new Vec3();
    Vec3 b = new Vec3();
    Vec3 c = new Vec3();
    for (int n = 0; n < mesh.triangleCount(); n++) {
      pieces.cut(mesh.corner(n, 0, a), mesh.corner(n, 1, b), mesh.corner(n, 2, c), this::addPiece);
    }
    return points;
  }

  private void addPiece(Vec3 a, Vec3 b, Vec3 c) {
    a.add(b, centre).add(c, centre).mul(1.0 / 3, centre);
    if (!isNearSample()) {
      points.add(centre.x, centre.y, centre.z);
      if (2 * points.count() > before.length) {
        grow();
      }
      link(points.count() - 1);
    }
  }

  private boolean isNearSample() {
    long i = cell(centre.x);
    long j = cell(centre.y);
    long k = cell(centre.z);
    for (int n = 0; n < 27; n++) {
      int sample = table[slot(i + n % 3 - 1, j + n / 3 % 3 - 1, k + n / 9 - 1)];
      for (; sample >= 0; sample = before[sample]) {
        if (points.squaredDistance(sample, centre) < squaredNearMm2) {
          return true;
        }
      }
    }
    return false;
  }

  private long cell(double mm) {
    return (long) Math.floor(mm / nearMm);
  }

  private int slot(long i, long j, long k) {
    long hash = ((i * 0x9e3779b97f4a7c15L) ^ j) * 0xc2b2ae3d27d4eb4fL;
    hash = (hash ^ k) * 0x165667b19e3779f9L;
    return (int) (hash >>> 32) & (table.length - 1);
  }

  private void link(int sample) {
    int slot = slot(cell(points.x(sample)), cell(points.y(sample)), cell(points.z(sample)));
    before[sample] = table[slot];
    table[slot] = sample;
  }

  private void grow() {
    table = new int[2 * table.length];
    before = new int[2 * before.length];
    Arrays.fill(table, -1);
    for (int n = 0; n < points.count() - 1; n++) {
      link(n);
    }
  }
}
