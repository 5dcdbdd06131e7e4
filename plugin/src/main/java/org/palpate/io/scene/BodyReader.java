package org.palpate.io.scene;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Reads the bodies of a scene from their volumes and meshes. The world is that of the first volume,
 * and that of the first mesh if there is no volume. Files whose axes are known otherwise are turned
 * into it.
 *
 * <p>Each volume has its own grid. One that lies on the voxels of the first volume, to a thousandth
 * of a voxel, gets the first one's. One thread.
 */
public final class BodyReader {
  private static final double SAME_GRID_VOXELS = 1e-3;

  private final Path sceneFile;
  private final SceneFile scene;
  private final Map<Path, VolumeReader> volumes = new LinkedHashMap<>();
  private final List<Path> sources = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();
  private final Segment[] segments;
  private final VoxelGrid[] grids;

  private BodyReader(SceneFile scene, Path sceneFile) {
    this.scene = scene;
    this.sceneFile = sceneFile;
    segments = new Segment[scene.bodies().size()];
    grids = new VoxelGrid[segments.length];
  }

  /**
   * Reads the bodies.
   *
   * @param sceneFile the scene file, to which the names of volumes and meshes are relative
   * @throws VolumeFormatException if a file or a segment cannot be read, a mesh is open, or a body
   *     has no voxel, or does not rest on one grid beside elastic bodies
   */
  public static PlacedVolume read(SceneFile scene, Path sceneFile) throws VolumeFormatException {
    return new BodyReader(scene, sceneFile).read();
  }

  private PlacedVolume read() throws VolumeFormatException {
    for (int n = 0; n < segments.length; n++) {
      if (scene.isElastic()) {
        requireAtRest(n);
      }
      open(n);
    }
    Optional<VolumeReader> first = volumes.values().stream().findFirst();
    CoordinateSystem world = world(first);
    VoxelGrid firstGrid = first.map(volume -> volume.header().grid()).orElse(null);
    for (Map.Entry<Path, VolumeReader> volume : volumes.entrySet()) {
      readBodies(volume.getKey(), volume.getValue(), ownGrid(volume.getValue(), firstGrid, world));
    }
    readMeshes(world);
    SegmentedVolume rest =
        new SegmentedVolume(
            first.isPresent() ? firstGrid : grids[0], List.of(segments), List.of(grids));
    if (scene.isElastic() && !rest.hasOneGrid()) {
      throw new VolumeFormatException(
          "elastic bodies and those beside them need one grid",
          sceneFile,
          "resample all bodies to the grid of the first volume");
    }
    List<Path> files = new ArrayList<>(List.of(sceneFile));
    volumes.values().forEach(volume -> files.addAll(volume.files()));
    for (int n = 0; n < segments.length; n++) {
      if (scene.bodies().get(n).isMesh() && !files.contains(sources.get(n))) {
        files.add(sources.get(n));
      }
    }
    return new PlacedVolume(
        rest,
        scene.bodies().stream().map(body -> new Placement(body.mobility(), body.pose())).toList(),
        world,
        files,
        notes,
        Optional.of(new OpenedScene(scene, sceneFile)));
  }

  private VolumeFormatException refusal(int body, String key, String what, String remedy) {
    return new VolumeFormatException("bodies[" + body + "]." + key + " " + what, sceneFile, remedy);
  }

  /** Refuses what does not stand at rest beside elastic bodies, which share a lattice with it. */
  private void requireAtRest(int n) throws VolumeFormatException {
    SceneBody body = scene.bodies().get(n);
    if (body.mobility() == Mobility.MOVABLE) {
      throw refusal(
          n, "mobility", "is movable, and another body is elastic", "write fixed or elastic");
    }
    if (!body.pose().sameBits(new Pose())) {
      throw refusal(n, "pose", "moves a body of a scene with elastic bodies", "leave it out");
    }
  }

  private void open(int n) throws VolumeFormatException {
    SceneBody body = scene.bodies().get(n);
    try {
      Path file = sceneFile.toAbsolutePath().resolveSibling(body.source()).normalize();
      sources.add(file);
      if (!body.isMesh() && !volumes.containsKey(file)) {
        volumes.put(file, VolumeFiles.open(file, ReadOptions.defaults()));
      }
    } catch (InvalidPathException e) {
      throw refusal(
          n, body.isMesh() ? "mesh" : "volume", "is no name of a file", "correct it in the file");
    }
  }

  /** Returns the axes of the first volume, or else of the first mesh. */
  private CoordinateSystem world(Optional<VolumeReader> first) throws VolumeFormatException {
    return first.isPresent()
        ? first.get().header().coordinateSystem()
        : MeshBody.axes(sources.get(0));
  }

  private SegmentSpec spec(int n) throws VolumeFormatException {
    SceneBody body = scene.bodies().get(n);
    String text = body.segment().orElse("nonzero");
    try {
      SegmentSpec spec = SegmentSpec.parse("body=" + text);
      return new SegmentSpec(body.name(), spec.rule(), SegmentBuilder.paletteColour(n));
    } catch (VolumeFormatException e) {
      throw refusal(
          n,
          "segment",
          "is not understood: " + text,
          "write >=1500, 300..900, label:7, name:Mandible or nonzero");
    }
  }

  private void readBodies(Path source, VolumeReader volume, VoxelGrid grid)
      throws VolumeFormatException {
    List<Integer> numbers = new ArrayList<>();
    List<SegmentSpec> wanted = new ArrayList<>();
    for (int n = 0; n < segments.length; n++) {
      if (!scene.bodies().get(n).isMesh() && sources.get(n).equals(source)) {
        numbers.add(n);
        wanted.add(spec(n));
      }
    }
    List<Segment> found = SegmentBuilder.read(volume, wanted).segments();
    for (int m = 0; m < found.size(); m++) {
      if (found.get(m).bits().solidCount() == 0) {
        throw refusal(
            numbers.get(m),
            "segment",
            "has no voxel",
            "palpate info --volume prints the values of a volume");
      }
      segments[numbers.get(m)] = found.get(m);
      grids[numbers.get(m)] = grid;
    }
  }

  /** Voxelizes the meshes as finely as the volumes are. */
  private void readMeshes(CoordinateSystem world) throws VolumeFormatException {
    double edgeMm =
        Arrays.stream(grids)
            .filter(grid -> grid != null)
            .mapToDouble(grid -> grid.metric().shortestEdgeMm())
            .min()
            .orElse(0);
    for (int n = 0; n < segments.length; n++) {
      if (scene.bodies().get(n).isMesh()) {
        MeshBody body = MeshBody.read(sources.get(n), world, edgeMm);
        body.note().ifPresent(notes::add);
        edgeMm = body.solid().grid().metric().shortestEdgeMm();
        grids[n] = body.solid().grid();
        segments[n] =
            new Segment(
                scene.bodies().get(n).name(), body.solid().bits(), SegmentBuilder.paletteColour(n));
      }
    }
  }

  /** Returns the grid of a volume in the world, which is the first one's if it lies on that. */
  private VoxelGrid ownGrid(VolumeReader volume, VoxelGrid first, CoordinateSystem world) {
    VoxelGrid grid = volume.header().grid();
    Optional<VoxelGrid> turned = AxisSigns.convert(grid, volume.header().coordinateSystem(), world);
    if (turned.isEmpty()) {
      notes.add(unknownAxes(volume.sourceName()));
    }
    VoxelGrid own = turned.orElse(grid);
    return isSame(own, first) ? first : own;
  }

  /** Returns a note about a file whose axes are not known, or are known in an unknown world. */
  public static String unknownAxes(String file) {
    return "The world axes of " + file + " are taken as those of the scene.";
  }

  private static boolean isSame(VoxelGrid own, VoxelGrid grid) {
    boolean isSame =
        own.sizeX() == grid.sizeX() && own.sizeY() == grid.sizeY() && own.sizeZ() == grid.sizeZ();
    for (int corner = 0; isSame && corner < 8; corner++) {
      Vec3 p =
          new Vec3(
              (corner & 1) * own.sizeX(),
              (corner >> 1 & 1) * own.sizeY(),
              (corner >> 2) * own.sizeZ());
      Vec3 there = grid.worldToGrid(own.gridToWorld(p, new Vec3()), new Vec3());
      isSame = there.sub(p, there).length() <= SAME_GRID_VOXELS;
    }
    return isSame;
  }
}
