package org.palpate.volume.fracture;

import java.util.List;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.ConnectedComponents;
import org.palpate.volume.ConnectedComponents.Neighbours;
import org.palpate.volume.VoxelGrid;

/** Splits a segment into fragments: its connected components, or the two parts beside a plane. */
public final class SegmentSplit {
  /** The most fragments of a split. */
  public static final int MOST_PARTS = 254;

  private SegmentSplit() {}

  /**
   * {@return the connected components, the largest first}
   *
   * @param bits the segment; not changed
   * @param grid its grid, kept in the fragments
   * @param neighbours which voxels belong together
   * @param leastVoxels smaller components are left out
   * @throws IllegalArgumentException if none is large enough, or more than {@link #MOST_PARTS} are
   */
  public static Fragments byComponents(
      BitCube bits, VoxelGrid grid, Neighbours neighbours, long leastVoxels) {
    long[] counts = new long[1];
    ConnectedComponents.visit(
        bits, neighbours, (voxels, count) -> counts[0] += count >= leastVoxels ? 1 : 0);
    if (counts[0] < 1 || counts[0] > MOST_PARTS) {
      throw new IllegalArgumentException(
          "unusable number of components: "
              + counts[0]
              + " of at least "
              + leastVoxels
              + " voxels: choose another least size, so that there are 1 to "
              + MOST_PARTS);
    }
    return fragments(bits, grid, ConnectedComponents.of(bits, neighbours, leastVoxels));
  }

  /**
   * {@return the voxels whose centres lie in front of a plane, where its normal points, and those
   * behind it or on it; the larger part first}
   *
   * @param bits the segment; not changed
   * @param grid its grid, kept in the fragments
   * @param pointMm a point of the plane, world mm
   * @param normal the normal of the plane, world; any length but 0
   * @throws IllegalArgumentException if all voxels lie on one side
   */
  public static Fragments byPlane(BitCube bits, VoxelGrid grid, Vec3 pointMm, Vec3 normal) {
    BitCube front = new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    BitCube behind = new BitCube(bits.sizeX(), bits.sizeY(), bits.sizeZ());
    Vec3 p = new Vec3();
    ConnectedComponents.visit(
        bits,
        Neighbours.FACES,
        (voxels, count) -> {
          for (int n = 0; n < 3 * count; n += 3) {
            p.set(voxels[n] + 0.5, voxels[n + 1] + 0.5, voxels[n + 2] + 0.5);
            grid.gridToWorld(p, p).sub(pointMm, p);
            (p.dot(normal) > 0 ? front : behind).set(voxels[n], voxels[n + 1], voxels[n + 2]);
          }
        });
    if (front.solidCount() == 0 || behind.solidCount() == 0) {
      throw new IllegalArgumentException(
          "the plane does not cut the segment: all voxels lie on one side: choose a point inside");
    }
    boolean isFrontLarger = front.solidCount() > behind.solidCount();
    return fragments(bits, grid, isFrontLarger ? List.of(front, behind) : List.of(behind, front));
  }

  private static Fragments fragments(BitCube bits, VoxelGrid grid, List<BitCube> parts) {
    long kept = parts.stream().mapToLong(BitCube::solidCount).sum();
    return new Fragments(grid, parts, bits.solidCount() - kept);
  }
}
