package org.palpate.tool;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.file.NumberText;
import org.palpate.io.format.MemoryCheck;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.rigid.tool.ErodedAwayException;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.ToolSampler;
import org.palpate.rigid.tool.ToolShape;
import org.palpate.rigid.tool.TriangleMesh;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Makes the tool that a user asked for. The spacing of its sample points follows from the voxels of
 * the scene: mode {@code body} then keeps a gap of about half a voxel.
 */
public final class ToolMaker {
  /** The most sample points of a shape; a larger one is sampled more coarsely. */
  static final int MOST_POINTS_OF_SHAPE = 100_000;

  /** The most sample points of any tool. */
  static final int MOST_POINTS = 1_000_000;

  /**
   * The cover radius of a shape, shortest voxel edges of the scene. A little below a half, so that
   * the clearance with its allowances is a half and fills whole cells.
   */
  private static final double COVER_EDGES = 0.498;

  /** The coarsest cover radius of a large shape, as a multiple of the finest. */
  private static final double COARSEST = 8;

  /** The edge of the voxels of a closed mesh, shortest voxel edges of the scene. */
  private static final double VOXEL_EDGES = 0.5;

  /** The approximate number of rim voxels of a mesh for each square voxel edge of its area. */
  private static final double RIM_VOXELS = 2;

  /**
   * The approximate number of samples of an open mesh for each squared cover radius of its area.
   */
  private static final double POINTS_OF_OPEN_MESH = 1.2;

  /** The longest side of the box around a mesh, shortest voxel edges of the scene. */
  private static final double LONGEST_EDGES = 4000;

  private final ToolRequest request;
  private final double edgeMm;
  private final CoordinateSystem world;
  private final List<Path> files = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();

  private ToolMaker(ToolRequest request, double edgeMm, CoordinateSystem world) {
    this.request = request;
    this.edgeMm = edgeMm;
    this.world = world;
  }

  /**
   * Makes a tool.
   *
   * @param edgeMm the shortest voxel edge of the scene, mm
   * @param world the directions of the world axes, into which files are converted
   * @throws VolumeFormatException if a file cannot be read, if the tool is too large for the voxels
   *     of the scene, or if erosion leaves nothing of it
   */
  public static MadeTool make(ToolRequest request, double edgeMm, CoordinateSystem world)
      throws VolumeFormatException {
    return new ToolMaker(request, edgeMm, world).make();
  }

  private MadeTool make() throws VolumeFormatException {
    Optional<TriangleMesh> mesh = readMesh();
    boolean isOpen = mesh.isPresent() && !mesh.get().isClosed();
    boolean isPoint = request.spec() instanceof ToolSpec.Point;
    boolean pointsOnly = isPoint || isOpen || request.points().isPresent();
    ClearanceChoice clearance =
        request.clearance().orElse(pointsOnly ? ClearanceChoice.POINTS : ClearanceChoice.BODY);
    double depthMm = Math.max(0, -clearance.marginMm());
    RigidTool whole = whole(mesh, depthMm);
    RigidTool tool = request.points().isPresent() ? thinned(whole) : whole;
    return new MadeTool(name(), tool, clearance, files, notes);
  }

  private String name() {
    return request.spec().name();
  }

  private Optional<TriangleMesh> readMesh() throws VolumeFormatException {
    if (request.spec() instanceof ToolSpec.MeshFile mesh) {
      files.add(mesh.file());
      return Optional.of(MeshFiles.read(mesh.file(), world));
    }
    return Optional.empty();
  }

  /** Returns the tool with all its points. */
  private RigidTool whole(Optional<TriangleMesh> mesh, double depthMm)
      throws VolumeFormatException {
    try {
      RigidTool tool = mesh.isPresent() ? ofMesh(mesh.get(), depthMm) : sampled(depthMm);
      requireFewPoints(tool);
      return tool;
    } catch (ErodedAwayException e) {
      throw nothingLeft(depthMm, e);
    }
  }

  private void requireFewPoints(RigidTool tool) throws VolumeFormatException {
    if (tool.count() > MOST_POINTS) {
      throw new VolumeFormatException(
          "the tool has "
              + NumberText.count(tool.count())
              + " points, more than "
              + NumberText.count(MOST_POINTS),
          "--tool " + name(),
          "crop the tool or resample it to larger voxels, or choose a margin farther from 0");
    }
  }

  private RigidTool sampled(double depthMm) throws VolumeFormatException {
    if (request.spec() instanceof ToolSpec.Shape shape) {
      return ofShape(shape.shape(), depthMm);
    }
    if (request.spec() instanceof ToolSpec.VolumeFile volume) {
      return ofVolume(volume.file(), depthMm);
    }
    return ToolSampler.point();
  }

  private RigidTool thinned(RigidTool whole) {
    RigidTool tool = whole.thinned(request.points().getAsInt());
    if (!tool.isCovered()) {
      notes.add(
          "The tool has "
              + tool.count()
              + " of its "
              + whole.count()
              + " points, so only these points keep clear of solids, not the whole tool.");
    }
    return tool;
  }

  private RigidTool ofShape(ToolShape shape, double depthMm) throws VolumeFormatException {
    double coverMm = lengthFor(shape.areaMm2() / 2, COVER_EDGES * edgeMm);
    return ToolSampler.ofErodedShape(shape, coverMm, depthMm);
  }

  /**
   * Returns the smallest length that does not give too many points: the finest one, or 2, 4 or 8
   * times that.
   *
   * @param areaMm2 the number of points times the squared length, mm^2
   * @param finestMm the finest length, mm
   */
  private double lengthFor(double areaMm2, double finestMm) throws VolumeFormatException {
    double lengthMm = finestMm;
    while (areaMm2 / (lengthMm * lengthMm) > MOST_POINTS_OF_SHAPE) {
      lengthMm *= 2;
      if (lengthMm > COARSEST * finestMm) {
        throw new VolumeFormatException(
            "the tool is too large for voxels of " + NumberText.display(edgeMm) + " mm",
            "--tool " + name(),
            "choose a smaller tool; lengths are in mm");
      }
    }
    return lengthMm;
  }

  private RigidTool ofMesh(TriangleMesh mesh, double depthMm) throws VolumeFormatException {
    Vec3 size = mesh.high().sub(mesh.low(), new Vec3());
    double longestMm = Math.max(size.x, Math.max(size.y, size.z));
    if (longestMm > LONGEST_EDGES * edgeMm) {
      throw new VolumeFormatException(
          "the mesh is "
              + NumberText.display(Math.rint(longestMm))
              + " mm long, too large for voxels of "
              + NumberText.display(edgeMm)
              + " mm",
          "--tool " + name(),
          "scale it to mm");
    }
    if (mesh.isClosed()) {
      return ofClosedMesh(mesh, depthMm);
    }
    if (depthMm > 0) {
      throw new VolumeFormatException(
          "the mesh is open and has no inside",
          "--tool " + name(),
          "close it, or choose --clearance points, body or a positive margin");
    }
    notes.add("The mesh is open, so its surface is sampled and nothing counts as its inside.");
    double coverMm = lengthFor(POINTS_OF_OPEN_MESH * mesh.areaMm2(), COVER_EDGES * edgeMm);
    return ToolSampler.ofSurface(mesh, coverMm);
  }

  private RigidTool ofClosedMesh(TriangleMesh mesh, double depthMm) throws VolumeFormatException {
    double voxelMm = lengthFor(RIM_VOXELS * mesh.areaMm2(), VOXEL_EDGES * edgeMm);
    double bytes = ToolSampler.bytesFor(mesh, voxelMm, depthMm);
    MemoryCheck.require(bytes, "the voxels of the tool", "--tool " + name());
    return ToolSampler.ofClosedMesh(mesh, voxelMm, depthMm);
  }

  private RigidTool ofVolume(Path file, double depthMm) throws VolumeFormatException {
    VolumeReader reader = VolumeFiles.open(file, ReadOptions.defaults());
    files.addAll(reader.files());
    SegmentSpec spec = request.segment().orElse(SegmentSpec.nonzero("tool"));
    BitCube bits = SegmentBuilder.read(reader, List.of(spec)).segments().get(0).bits();
    if (bits.solidCount() == 0) {
      throw new VolumeFormatException(
          "no voxel of the tool is solid",
          file,
          "choose its voxels with --tool-segment; palpate info --volume prints the values");
    }
    return ofVoxels(bits, inWorld(reader, file), depthMm);
  }

  private RigidTool ofVoxels(BitCube bits, VoxelGrid grid, double depthMm)
      throws VolumeFormatException {
    MemoryCheck.require(ToolSampler.bytesFor(bits, grid, depthMm), "the tool", "--tool " + name());
    return ToolSampler.ofErodedSegment(bits, grid, depthMm);
  }

  private static VolumeFormatException nothingLeft(double depthMm, ErodedAwayException cause) {
    return new VolumeFormatException(
        "no part of the tool lies deeper than "
            + NumberText.display(depthMm)
            + " mm below its surface",
        "--clearance " + NumberText.display(-depthMm),
        "choose a margin nearer to 0",
        cause);
  }

  /** Returns the grid of a volume with its axes turned into those of the world of the scene. */
  private VoxelGrid inWorld(VolumeReader reader, Path file) {
    VoxelGrid grid = reader.header().grid();
    Optional<VoxelGrid> turned = AxisSigns.convert(grid, reader.header().coordinateSystem(), world);
    if (turned.isEmpty()) {
      notes.add("The world axes of " + file + " are taken as those of the scene.");
    }
    return turned.orElse(grid);
  }
}
