package org.palpate.io.scene;

import java.nio.file.Path;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.rigid.tool.MeshVoxelizer;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.rigid.tool.TriangleMesh;
import org.palpate.rigid.tool.VoxelSolid;

/**
 * A closed mesh that is a body of a scene, or a ghost.
 *
 * @param solid its voxels, which are cubes with corners at multiples of their edge in the world
 * @param note what the user should know of its axes
 */
record MeshBody(VoxelSolid solid, Optional<String> note) {
  /** The longest side of the box around a mesh, voxel edges. */
  private static final double LONGEST_EDGES = 4000;

  /** The same in a scene without volumes, whose first mesh chooses the voxels. */
  private static final double EDGES_OF_FIRST = 256;

  /**
   * Returns the axes that a file names.
   *
   * @throws VolumeFormatException if it is no mesh, or cannot be read
   */
  static CoordinateSystem axes(Path file) throws VolumeFormatException {
    if (!MeshFiles.accepts(file)) {
      throw new VolumeFormatException(
          "this kind of file is no mesh", file, "name a .stl, .obj or .ply file");
    }
    return MeshFiles.axes(file);
  }

  /**
   * Reads a mesh in a world.
   *
   * @param edgeMm the edge of its voxels; 0 for 1/256 of its longest side
   * @throws VolumeFormatException if the file cannot be read, or the mesh is open or too large
   */
  static MeshBody read(Path file, CoordinateSystem world, double edgeMm)
      throws VolumeFormatException {
    boolean isUnnamed = (axes(file) == CoordinateSystem.UNKNOWN) != isUnknown(world);
    TriangleMesh mesh = MeshFiles.read(file, world);
    if (!mesh.isClosed()) {
      throw new VolumeFormatException(
          "the mesh is open, so it has no inside", file, "close its holes, and export it again");
    }
    Vec3 size = mesh.high().sub(mesh.low(), new Vec3());
    double longestMm = Math.max(size.x, Math.max(size.y, size.z));
    double voxelMm = edgeMm > 0 ? edgeMm : longestMm / EDGES_OF_FIRST;
    if (longestMm > LONGEST_EDGES * voxelMm) {
      throw new VolumeFormatException(
          "the mesh is "
              + NumberText.display(Math.rint(longestMm))
              + " mm long, too large for voxels of "
              + NumberText.display(voxelMm)
              + " mm",
          file,
          "scale it to mm");
    }
    MemoryCheck.require(ToolSampler.bytesFor(mesh, voxelMm, 0), "the mesh", file.toString());
    return new MeshBody(
        MeshVoxelizer.onMultiples(mesh, voxelMm).voxelizeBody(),
        isUnnamed ? Optional.of(BodyReader.unknownAxes(file.toString())) : Optional.empty());
  }

  private static boolean isUnknown(CoordinateSystem world) {
    return world == CoordinateSystem.UNKNOWN;
  }
}
