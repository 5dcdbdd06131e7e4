package org.palpate.rigid;

import java.util.Arrays;
import org.palpate.body.Body;
import org.palpate.body.Mobility;
import org.palpate.geometry.AffineMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Makes tools: from a shape by even samples of its surface, from a segment of a volume by the
 * centres of its rim voxels.
 *
 * <p>Rim voxels are solid voxels with an empty neighbour across a face. Every surface point of the
 * segment lies on an open face of one of them, hence within half a voxel's diagonal of its centre.
 */
public final class ToolSampler {
  /** Cells along the longest side of a shape when its matter is summed. */
  private static final int CELLS_OF_SHAPE = 64;

  private double[] x = new double[1024];
  private double[] y = new double[1024];
  private double[] z = new double[1024];
  private int count;

  private ToolSampler() {}

  /** Returns a tool of a single point, which has no extent. */
  public static ToolPoints point() {
    double[][] origin = {{0}, {0}, {0}};
    KineticMetric metric = new KineticMetric(0, 0, 0, 0, 0, 0);
    return new ToolPoints(origin, metric, 0, new Vec3(), (a, b, c) -> false);
  }

  /**
   * Samples a shape. The reference point is its centroid.
   *
   * @param coverRadiusMm the largest distance of a surface point from its nearest sample
   */
  public static ToolPoints ofShape(ToolShape shape, double coverRadiusMm) {
    if (!(coverRadiusMm > 0)) {
      throw new IllegalArgumentException("coverRadiusMm must be positive: " + coverRadiusMm);
    }
    SecondMoments moments = momentsOf(shape);
    ToolSampler sampler = new ToolSampler();
    shape.sampleSurface(coverRadiusMm, sampler::add);
    Vec3 reference = new Vec3(moments.meanX(), moments.meanY(), moments.meanZ());
    ToolSolid solid =
        (a, b, c) -> shape.contains(a + reference.x, b + reference.y, c + reference.z);
    return sampler.tool(moments, coverRadiusMm, reference, solid);
  }

  private static SecondMoments momentsOf(ToolShape shape) {
    Vec3 low = shape.low();
    Vec3 size = shape.high().sub(low, new Vec3());
    double cell = Math.max(size.x, Math.max(size.y, size.z)) / CELLS_OF_SHAPE;
    int cellsX = (int) Math.ceil(size.x / cell);
    int cellsY = (int) Math.ceil(size.y / cell);
    int cellsZ = (int) Math.ceil(size.z / cell);
    SecondMoments moments = new SecondMoments();
    for (int k = 0; k < cellsZ; k++) {
      for (int j = 0; j < cellsY; j++) {
        for (int i = 0; i < cellsX; i++) {
          double px = low.x + (i + 0.5) * size.x / cellsX;
          double py = low.y + (j + 0.5) * size.y / cellsY;
          double pz = low.z + (k + 0.5) * size.z / cellsZ;
          if (shape.contains(px, py, pz)) {
            moments.add(px, py, pz);
          }
        }
      }
    }
    return moments;
  }

  /**
   * Samples a segment by its rim voxels. The reference point is the mean of the centres of all
   * solid voxels; at the identity orientation the tool's axes are the world's.
   *
   * @param grid the segment's grid
   * @param parts into how many parts the shortest edge of a voxel is cut; longer edges are cut so
   *     that parts are about cubes
   */
  public static ToolPoints ofSegment(BitCube bits, VoxelGrid grid, int parts) {
    if (bits.solidCount() == 0) {
      throw new IllegalArgumentException("the tool's segment has no voxels");
    }
    SecondMoments moments = new SecondMoments();
    Vec3 p = new Vec3();
    forEachSolid(
        bits,
        (i, j, k) -> {
          grid.gridToWorld(p.set(i + 0.5, j + 0.5, k + 0.5), p);
          moments.add(p.x, p.y, p.z);
        });
    RimCells rim = new RimCells(bits, grid, parts);
    ToolSampler sampler = new ToolSampler();
    forEachSolid(bits, (i, j, k) -> rim.sample(i, j, k, sampler::add));
    Vec3 reference = new Vec3(moments.meanX(), moments.meanY(), moments.meanZ());
    return sampler.tool(moments, rim.coverRadiusMm(), reference, solidOf(bits, grid, reference));
  }

  private static ToolSolid solidOf(BitCube bits, VoxelGrid grid, Vec3 reference) {
    Pose atReference = new Pose();
    atReference.translation.set(reference);
    AffineMap toGrid =
        new Body("tool", bits, grid, Mobility.MOVABLE).toolToGrid(atReference, new AffineMap());
    return (a, b, c) ->
        bits.get(
            (int) Math.floor(toGrid.x(a, b, c)),
            (int) Math.floor(toGrid.y(a, b, c)),
            (int) Math.floor(toGrid.z(a, b, c)));
  }

  /** Takes the coordinates of a voxel. */
  @FunctionalInterface
  private interface VoxelSink {
    void take(int i, int j, int k);
  }

  private static void forEachSolid(BitCube bits, VoxelSink sink) {
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

  private void add(double px, double py, double pz) {
    if (count == x.length) {
      x = Arrays.copyOf(x, 2 * count);
      y = Arrays.copyOf(y, 2 * count);
      z = Arrays.copyOf(z, 2 * count);
    }
    x[count] = px;
    y[count] = py;
    z[count] = pz;
    count++;
  }

  private ToolPoints tool(
      SecondMoments moments, double coverRadiusMm, Vec3 reference, ToolSolid solid) {
    double[][] points = {Arrays.copyOf(x, count), Arrays.copyOf(y, count), Arrays.copyOf(z, count)};
    for (int n = 0; n < count; n++) {
      points[0][n] -= reference.x;
      points[1][n] -= reference.y;
      points[2][n] -= reference.z;
    }
    KineticMetric metric = new KineticMetric(moments.covariance());
    return new ToolPoints(points, metric, coverRadiusMm, reference, solid);
  }
}
