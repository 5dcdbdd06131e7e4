package org.palpate.io.scene;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
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
 * Reads the bodies of a scene from their volumes. All volumes must have the grid of the first one,
 * to a thousandth of a voxel. One thread an instance.
 */
public final class BodyReader {
  private static final double SAME_GRID_VOXELS = 1e-3;

  private final Path sceneFile;
  private final SceneFile scene;
  private final Map<Path, VolumeReader> volumes = new LinkedHashMap<>();
  private final List<Path> sources = new ArrayList<>();
  private final List<String> notes = new ArrayList<>();

  private BodyReader(SceneFile scene, Path sceneFile) {
    this.scene = scene;
    this.sceneFile = sceneFile;
    List<String> unused = scene.unusedKeys();
    if (!unused.isEmpty()) {
      notes.add("The scene has keys that are not used yet: " + String.join(", ", unused) + ".");
    }
  }

  /**
   * Reads the bodies.
   *
   * @param sceneFile the scene file, to which the names of volumes are relative
   * @throws VolumeFormatException if a volume or a segment cannot be read, a body has no voxel, is
   *     a mesh, stands on another grid, or does not rest beside elastic bodies
   */
  public static PlacedVolume read(SceneFile scene, Path sceneFile) throws VolumeFormatException {
    return new BodyReader(scene, sceneFile).read();
  }

  private PlacedVolume read() throws VolumeFormatException {
    List<SegmentSpec> specs = new ArrayList<>();
    for (int n = 0; n < scene.bodies().size(); n++) {
      specs.add(spec(n));
      open(n);
    }
    VolumeReader first = volumes.get(sources.get(0));
    CoordinateSystem world = first.header().coordinateSystem();
    Segment[] segments = new Segment[specs.size()];
    for (Map.Entry<Path, VolumeReader> volume : volumes.entrySet()) {
      requireSameGrid(first, volume.getValue());
      readBodies(volume.getKey(), volume.getValue(), specs, segments);
    }
    List<Path> files = new ArrayList<>(List.of(sceneFile));
    volumes.values().forEach(volume -> files.addAll(volume.files()));
    return new PlacedVolume(
        new SegmentedVolume(first.header().grid(), List.of(segments)),
        scene.bodies().stream().map(body -> new Placement(body.mobility(), body.pose())).toList(),
        world,
        files,
        notes);
  }

  private VolumeFormatException refusal(int body, String key, String what, String remedy) {
    return new VolumeFormatException("bodies[" + body + "]." + key + " " + what, sceneFile, remedy);
  }

  private SegmentSpec spec(int n) throws VolumeFormatException {
    SceneBody body = scene.bodies().get(n);
    if (body.isMesh()) {
      throw refusal(
          n, "mesh", "is a mesh, which cannot be a body yet", "convert it to a label volume");
    }
    if (scene.isElastic()) {
      requireAtRest(n);
    }
    String text = body.segment().orElse("nonzero");
    try {
      SegmentSpec spec = SegmentSpec.parse("body=" + text);
      return new SegmentSpec(body.name(), spec.rule(), spec.rgb());
    } catch (VolumeFormatException e) {
      throw refusal(
          n,
          "segment",
          "is not understood: " + text,
          "write >=1500, 300..900, label:7, name:Mandible or nonzero");
    }
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
    String source = scene.bodies().get(n).source();
    try {
      Path file = sceneFile.toAbsolutePath().resolveSibling(source).normalize();
      sources.add(file);
      if (!volumes.containsKey(file)) {
        volumes.put(file, VolumeFiles.open(file, ReadOptions.defaults()));
      }
    } catch (InvalidPathException e) {
      throw refusal(n, "volume", "is no name of a file", "correct it in the file");
    }
  }

  private void readBodies(
      Path source, VolumeReader volume, List<SegmentSpec> specs, Segment[] segments)
      throws VolumeFormatException {
    List<Integer> numbers = new ArrayList<>();
    List<SegmentSpec> wanted = new ArrayList<>();
    for (int n = 0; n < specs.size(); n++) {
      if (sources.get(n).equals(source)) {
        numbers.add(n);
        wanted.add(specs.get(n));
      }
    }
    List<Segment> found = SegmentBuilder.read(volume, wanted).segments();
    for (int m = 0; m < found.size(); m++) {
      segments[numbers.get(m)] = found.get(m);
      if (found.get(m).bits().solidCount() == 0) {
        throw refusal(
            numbers.get(m),
            "segment",
            "has no voxel",
            "palpate info --volume prints the values of a volume");
      }
    }
  }

  private void requireSameGrid(VolumeReader first, VolumeReader other)
      throws VolumeFormatException {
    VoxelGrid grid = first.header().grid();
    VoxelGrid own = inWorld(other, first.header().coordinateSystem());
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
    if (!isSame) {
      throw new VolumeFormatException(
          "its voxels do not lie on those of "
              + first.sourceName()
              + ", the first volume of the scene",
          other.sourceName(),
          "resample it to that grid");
    }
  }

  /** Returns the grid of a volume with its axes turned into those of the scene's world. */
  private VoxelGrid inWorld(VolumeReader volume, CoordinateSystem world) {
    VoxelGrid grid = volume.header().grid();
    Optional<VoxelGrid> turned = AxisSigns.convert(grid, volume.header().coordinateSystem(), world);
    if (turned.isEmpty()) {
      notes.add("The world axes of " + volume.sourceName() + " are taken as those of the scene.");
    }
    return turned.orElse(grid);
  }
}
