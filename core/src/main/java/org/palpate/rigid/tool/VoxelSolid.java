package org.palpate.rigid.tool;

import org.palpate.geometry.AffineMap;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * A solid of voxels, of which a tool or a body is made. The caller keeps the bits and does not
 * change them.
 *
 * @param bits the voxels
 * @param grid their grid, in the world
 */
public record VoxelSolid(BitCube bits, VoxelGrid grid) {
  /** The largest number of parts into which the shortest edge of a voxel is cut. */
  static final int MOST_PARTS = 8;

  /** Takes the coordinates of a voxel. */
  @FunctionalInterface
  interface VoxelSink {
    void take(int i, int j, int k);
  }

  /** Returns the properties of the solid voxels, each as a point at its centre, world mm. */
  MassProperties massProperties() {
    MomentSum sum = new MomentSum();
    Vec3 p = new Vec3();
    forEachSolid(
        (i, j, k) -> {
          grid.gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
          sum.add(p.x, p.y, p.z);
        });
    return sum.massProperties();
  }

  /** Calls the sink for each solid voxel, brick by brick. */
  void forEachSolid(VoxelSink sink) {
    for (int z = 0; z < bits.bricksZ(); z++) {
      for (int y = 0; y < bits.bricksY(); y++) {
        for (int x = 0; x < bits.bricksX(); x++) {
          for (long rest = bits.brick(x, y, z); rest != 0; rest &= rest - 1) {
            int bit = Long.numberOfTrailingZeros(rest);
            sink.take((x << 2) + (bit & 3), (y << 2) + (bit >> 2 & 3), (z << 2) + (bit >> 4));
          }
        }
      }
    }
  }

  /** Returns the solid on the smallest grid that contains it. */
  VoxelSolid cropped() {
    IntBox box = bits.bounds();
    int sizeX = box.highX - box.lowX + 1;
    int sizeY = box.highY - box.lowY + 1;
    int sizeZ = box.highZ - box.lowZ + 1;
    BitCube inside = new BitCube(sizeX, sizeY, sizeZ);
    forEachSolid((i, j, k) -> inside.set(i - box.lowX, j - box.lowY, k - box.lowZ));
    Vec3 corner = grid.gridToWorld(new Vec3(box.lowX, box.lowY, box.lowZ), new Vec3());
    RigidTransform t = grid.gridMmToWorld();
    RigidTransform moved = new RigidTransform(t.axisX(), t.axisY(), t.axisZ(), corner);
    return new VoxelSolid(inside, new VoxelGrid(sizeX, sizeY, sizeZ, grid.spacingMm(), moved));
  }

  /**
   * Returns the same solid made of smaller voxels that are about cubes.
   *
   * @param longestEdgeMm edges are at most this long, mm, as far as {@link #MOST_PARTS} parts of
   *     the shortest edge allow
   */
  VoxelSolid refined(double longestEdgeMm) {
    Vec3 s = grid.spacingMm();
    double edgeMm = partMm(grid.metric().shortestEdgeMm(), longestEdgeMm);
    int partsX = parts(s.x, edgeMm);
    int partsY = parts(s.y, edgeMm);
    int partsZ = parts(s.z, edgeMm);
    if (partsX == 1 && partsY == 1 && partsZ == 1) {
      return this;
    }
    BitCube fine = new BitCube(bits.sizeX() * partsX, bits.sizeY() * partsY, bits.sizeZ() * partsZ);
    forEachSolid(
        (i, j, k) -> fill(fine, i * partsX, j * partsY, k * partsZ, partsX, partsY, partsZ));
    Vec3 spacing = new Vec3(s.x / partsX, s.y / partsY, s.z / partsZ);
    return new VoxelSolid(
        fine,
        new VoxelGrid(fine.sizeX(), fine.sizeY(), fine.sizeZ(), spacing, grid.gridMmToWorld()));
  }

  /** Returns the memory of the cropped solid after {@link #refined} and an erosion, bytes. */
  double refinedBytes(double longestEdgeMm) {
    IntBox box = bits.bounds();
    Vec3 s = grid.spacingMm();
    double edgeMm = partMm(grid.metric().shortestEdgeMm(), longestEdgeMm);
    double x = (box.highX - box.lowX + 1.0) * parts(s.x, edgeMm);
    double y = (box.highY - box.lowY + 1.0) * parts(s.y, edgeMm);
    double z = (box.highZ - box.lowZ + 1.0) * parts(s.z, edgeMm);
    return x * y * z / 4;
  }

  /** Returns the number of parts into which {@link #refined} cuts each edge of a cube. */
  static int partsOfCube(double edgeMm, double longestEdgeMm) {
    return parts(edgeMm, partMm(edgeMm, longestEdgeMm));
  }

  private static double partMm(double shortestMm, double longestEdgeMm) {
    return Math.max(Math.min(longestEdgeMm, shortestMm), shortestMm / MOST_PARTS);
  }

  /** Returns the number of parts of an edge; 1 if only rounding makes the edge too long. */
  private static int parts(double edgeMm, double longestMm) {
    return Math.max(1, (int) Math.ceil(edgeMm / longestMm - 1e-9));
  }

  private static void fill(BitCube fine, int i, int j, int k, int sizeX, int sizeY, int sizeZ) {
    for (int w = k; w < k + sizeZ; w++) {
      for (int v = j; v < j + sizeY; v++) {
        for (int u = i; u < i + sizeX; u++) {
          fine.set(u, v, w);
        }
      }
    }
  }

  /**
   * Returns the voxels that are left after a layer is taken off the surface. Takes a voxel off if
   * all of it lies within the depth of one empty voxel. So each point that is deeper than that
   * stays.
   *
   * @param depthMm the thickness of the layer, mm, positive
   */
  VoxelSolid eroded(double depthMm) {
    BitCube left = bits.copy();
    forEachSolid(
        (i, j, k) -> {
          for (int face = 0; face < 6; face++) {
            int step = 2 * (face & 1) - 1;
            int x = face < 2 ? i + step : i;
            int y = face >> 1 == 1 ? j + step : j;
            int z = face >= 4 ? k + step : k;
            if (!bits.get(x, y, z)) {
              takeOffAround(left, x, y, z, depthMm);
            }
          }
        });
    left.tightenBounds();
    return new VoxelSolid(left, grid);
  }

  /** Takes off the voxels that lie within the depth of the empty voxel (i,j,k) as a whole. */
  private void takeOffAround(BitCube left, int i, int j, int k, double depthMm) {
    Vec3 s = grid.spacingMm();
    int reachX = reach(depthMm, s.x);
    int reachY = reach(depthMm, s.y);
    int reachZ = reach(depthMm, s.z);
    for (int w = Math.max(0, k - reachZ); w <= Math.min(bits.sizeZ() - 1, k + reachZ); w++) {
      double farZ = s.z * (w - k);
      for (int v = Math.max(0, j - reachY); v <= Math.min(bits.sizeY() - 1, j + reachY); v++) {
        double farY = s.y * (v - j);
        for (int u = Math.max(0, i - reachX); u <= Math.min(bits.sizeX() - 1, i + reachX); u++) {
          double farX = s.x * (u - i);
          if (farX * farX + farY * farY + farZ * farZ <= depthMm * depthMm) {
            left.clear(u, v, w);
          }
        }
      }
    }
  }

  private static int reach(double depthMm, double spacingMm) {
    return (int) Math.min(1 << 20, depthMm / spacingMm);
  }

  /** Adds the centres of all rim voxels, world mm. */
  void sampleRim(ToolShape.PointSink sink) {
    Vec3 p = new Vec3();
    forEachSolid(
        (i, j, k) -> {
          if (!bits.isSurrounded(i, j, k)) {
            grid.gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
            sink.add(p.x, p.y, p.z);
          }
        });
  }

  /**
   * Returns the cover radius of the centres of the rim voxels: half the diagonal of a voxel, world
   * mm. Each surface point lies on a face of a rim voxel.
   */
  double coverRadiusMm() {
    return 0.5 * grid.spacingMm().length() * (1 + grid.gridMmToWorld().distortion());
  }

  /** Returns this solid in a frame whose origin is the reference point, along the world's axes. */
  ToolSolid relativeTo(Vec3 referenceMm) {
    AffineMap toGrid = grid.worldToGrid(new AffineMap());
    double x = referenceMm.x;
    double y = referenceMm.y;
    double z = referenceMm.z;
    return (a, b, c) ->
        bits.get(
            (int) Math.floor(toGrid.x(a + x, b + y, c + z)),
            (int) Math.floor(toGrid.y(a + x, b + y, c + z)),
            (int) Math.floor(toGrid.z(a + x, b + y, c + z)));
  }
}
