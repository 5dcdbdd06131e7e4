package org.palpate.rigid.tool;

import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Makes rigid tools. A shape and an open mesh are sampled evenly on their surfaces. A segment is
 * sampled at the centres of its rim voxels, and a closed mesh is voxelized first. A rim voxel is a
 * solid voxel with an empty neighbour across a face.
 *
 * <p>A tool may be eroded: then its sample points lie on the surface of the part of the solid that
 * is deeper than a given depth. Such a tool may overlap a body by that depth and no more, in mode
 * {@code body}. Erosion changes neither the reference point nor the metric.
 */
public final class ToolSampler {
  private ToolSampler() {}

  /** {@return a tool of a single point, which has no extent} */
  public static RigidTool point() {
    double[][] origin = {{0}, {0}, {0}};
    KineticMetric metric = new KineticMetric(0, 0, 0, 0, 0, 0);
    return new RigidTool(origin, metric, 0, new Vec3(), (a, b, c) -> false);
  }

  /**
   * {@return a tool whose points sample a shape} The reference point is its centroid.
   *
   * @param shape the shape, in its own frame
   * @param coverRadiusMm the largest distance of a surface point from its nearest sample, positive
   */
  public static RigidTool ofShape(ToolShape shape, double coverRadiusMm) {
    return ofErodedShape(shape, coverRadiusMm, 0);
  }

  /**
   * {@return a tool whose points sample an eroded shape} The reference point is the centroid of the
   * whole shape.
   *
   * @param shape the whole shape, in its own frame
   * @param coverRadiusMm the largest distance of a surface point from its nearest sample, positive
   * @param depthMm the depth of the erosion, mm; 0 for none
   * @throws ErodedAwayException if no point of the shape is that deep
   * @throws IllegalArgumentException if the cover radius is not positive
   */
  public static RigidTool ofErodedShape(ToolShape shape, double coverRadiusMm, double depthMm) {
    if (!(coverRadiusMm > 0)) {
      throw new IllegalArgumentException("coverRadiusMm must be positive: " + coverRadiusMm);
    }
    ToolShape eroded = depthMm == 0 ? shape : eroded(shape, depthMm);
    MassProperties mass = shape.massProperties();
    Vec3 reference = mass.centroidMm();
    PointList points = new PointList();
    eroded.sampleSurface(coverRadiusMm, points);
    ToolSolid solid = new ShapeSolid(eroded, reference);
    return new RigidTool(
        points.relativeTo(reference), mass.metric(), coverRadiusMm, reference, solid);
  }

  private static ToolShape eroded(ToolShape shape, double depthMm) {
    return shape.eroded(depthMm).orElseThrow(() -> new ErodedAwayException(depthMm));
  }

  /**
   * {@return a tool whose points sample a segment by its rim voxels} The reference point is the
   * mean of the centres of all solid voxels; at the identity orientation the tool's axes are the
   * world's. Long voxels are cut into parts that are about cubes.
   *
   * @param bits the segment, which the caller no longer changes
   * @param grid the segment's grid
   * @throws IllegalArgumentException if the segment has no voxels
   */
  public static RigidTool ofSegment(BitCube bits, VoxelGrid grid) {
    return ofErodedSegment(bits, grid, 0);
  }

  /**
   * {@return a tool whose points sample an eroded segment by its rim voxels} The reference point is
   * the mean of the centres of all solid voxels of the whole segment.
   *
   * @param bits the segment, which the caller no longer changes
   * @param grid the grid of the segment
   * @param depthMm the depth of the erosion, mm; 0 for none
   * @throws IllegalArgumentException if the segment has no voxels
   * @throws ErodedAwayException if no point of the segment is that deep
   */
  public static RigidTool ofErodedSegment(BitCube bits, VoxelGrid grid, double depthMm) {
    return ofErodedSegment(bits, grid, depthMm, longestEdgeMm(depthMm));
  }

  /**
   * {@return a tool of an eroded segment as {@link #ofErodedSegment(BitCube, VoxelGrid, double)}
   * does, but more densely if wanted}
   *
   * @param bits the segment, which the caller no longer changes
   * @param grid the grid of the segment
   * @param depthMm the depth of the erosion, mm; 0 for none
   * @param longestEdgeMm the longest edge of the voxels whose centres are sampled, mm
   * @throws IllegalArgumentException if the segment has no voxels
   * @throws ErodedAwayException if no point of the segment is that deep
   */
  public static RigidTool ofErodedSegment(
      BitCube bits, VoxelGrid grid, double depthMm, double longestEdgeMm) {
    if (bits.solidCount() == 0) {
      throw new IllegalArgumentException("the tool's segment has no voxels");
    }
    VoxelSolid whole = new VoxelSolid(bits, grid).cropped();
    VoxelSolid sampled = whole.refined(longestEdgeMm);
    if (depthMm > 0) {
      sampled = sampled.eroded(depthMm);
    }
    if (sampled.bits().solidCount() == 0) {
      throw new ErodedAwayException(depthMm);
    }
    return ofVoxels(sampled, whole.massProperties());
  }

  /** Layers that are thinner than a voxel need voxels that are as thin. */
  private static double longestEdgeMm(double depthMm) {
    return depthMm == 0 ? Double.POSITIVE_INFINITY : depthMm;
  }

  /**
   * {@return the memory that a tool of a segment takes while it is made, bytes}
   *
   * @param bits the segment
   * @param grid the grid of the segment
   * @param depthMm the depth of the erosion, mm; 0 for none
   */
  public static double bytesFor(BitCube bits, VoxelGrid grid, double depthMm) {
    return bytesOfEdges(bits, grid, longestEdgeMm(depthMm));
  }

  /**
   * {@return the memory that a tool of a segment takes while it is made with short voxels, bytes}
   *
   * @param bits the segment
   * @param grid the grid of the segment
   * @param longestEdgeMm the longest edge of the voxels whose centres are sampled, mm
   */
  public static double bytesOfEdges(BitCube bits, VoxelGrid grid, double longestEdgeMm) {
    return new VoxelSolid(bits, grid).refinedBytes(longestEdgeMm);
  }

  /**
   * {@return the memory that a tool of a closed mesh takes while it is made, bytes}
   *
   * @param mesh the mesh
   * @param edgeMm the edge of a voxel, mm
   * @param depthMm the depth of the erosion, mm; 0 for none
   */
  public static double bytesFor(TriangleMesh mesh, double edgeMm, double depthMm) {
    Vec3 size = mesh.high().sub(mesh.low(), new Vec3());
    double voxels = (size.x / edgeMm + 3) * (size.y / edgeMm + 3) * (size.z / edgeMm + 3);
    double parts = VoxelSolid.partsOfCube(edgeMm, longestEdgeMm(depthMm));
    return voxels * parts * parts * parts / 4;
  }

  /**
   * Voxelizes a closed mesh, and samples the voxels of its rim. The voxels contain the whole solid
   * of the mesh. The reference point is the centroid of its volume, and the tool's axes are those
   * of the mesh.
   *
   * @param mesh the mesh, in its own frame
   * @param edgeMm the edge of a voxel, mm
   * @param depthMm the depth of an erosion, mm; 0 for none
   * @return the tool
   * @throws IllegalArgumentException if the mesh is not closed
   * @throws ErodedAwayException if no point of the mesh is that deep
   */
  public static RigidTool ofClosedMesh(TriangleMesh mesh, double edgeMm, double depthMm) {
    if (!mesh.isClosed()) {
      throw new IllegalArgumentException("the mesh is not closed");
    }
    VoxelSolid solid = new MeshVoxelizer(mesh, edgeMm).voxelize().cropped();
    if (depthMm > 0) {
      solid = solid.refined(depthMm).eroded(depthMm);
    }
    if (solid.bits().solidCount() == 0) {
      throw new ErodedAwayException(depthMm);
    }
    return ofVoxels(solid, mesh.massProperties());
  }

  /**
   * {@return a tool whose points sample the surface of a mesh that need not be closed} The
   * reference point is the centroid of its area, or of its volume if it is closed.
   *
   * @param mesh the mesh, in its own frame
   * @param coverRadiusMm the largest distance of a surface point from its nearest sample, positive
   */
  public static RigidTool ofSurface(TriangleMesh mesh, double coverRadiusMm) {
    MassProperties mass = mesh.massProperties();
    Vec3 reference = mass.centroidMm();
    PointList points = new SurfaceSampler(coverRadiusMm).sample(mesh);
    return new RigidTool(
        points.relativeTo(reference), mass.metric(), coverRadiusMm, reference, null);
  }

  private static RigidTool ofVoxels(VoxelSolid solid, MassProperties mass) {
    Vec3 reference = mass.centroidMm();
    PointList points = new PointList();
    solid.sampleRim(points);
    return new RigidTool(
        points.relativeTo(reference),
        mass.metric(),
        solid.coverRadiusMm(),
        reference,
        solid.relativeTo(reference));
  }
}
