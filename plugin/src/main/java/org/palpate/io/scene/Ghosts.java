package org.palpate.io.scene;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.io.VolumeFiles;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.mesh.MeshFiles;
import org.palpate.io.volume.AxisSigns;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Ghosts: segments of files that are drawn faintly, for a hand to aim at. Nothing touches them.
 *
 * @param segments the ghosts, each on its own grid, which lies in the world of the scene
 * @param files the files that hold them, which no output may replace
 * @param notes what the user should know, a sentence each
 */
public record Ghosts(SegmentedVolume segments, List<Path> files, List<String> notes) {
  private static final int RGB = 0x8FF0E0;

  /** Copies the lists. */
  public Ghosts {
    files = List.copyOf(files);
    notes = List.copyOf(notes);
  }

  /**
   * Reads ghosts. The first is called ghost, the others ghost2, ghost3 and so on.
   *
   * @param texts {@code FILE} or {@code FILE:RULE} for each, at least one, with a rule as in {@code
   *     --segment}; without one, a ghost is all that is not 0. The file may be a closed mesh
   * @param world the directions of the scene's world axes, into which files are turned
   * @throws VolumeFormatException if a file cannot be read, a mesh is open, a rule is not
   *     understood, or a ghost has no voxel
   */
  public static Ghosts read(List<String> texts, CoordinateSystem world)
      throws VolumeFormatException {
    List<Ghost> ghosts = new ArrayList<>();
    for (String text : texts) {
      String name = ghosts.isEmpty() ? "ghost" : "ghost" + (ghosts.size() + 1);
      Source source = Source.parse(text, name);
      ghosts.add(
          MeshFiles.accepts(source.file()) ? source.readMesh(world) : source.readVolume(world));
    }
    List<VoxelGrid> grids = ghosts.stream().map(Ghost::grid).toList();
    List<Segment> segments = ghosts.stream().map(Ghost::segment).toList();
    return new Ghosts(
        new SegmentedVolume(grids.get(0), segments, grids),
        ghosts.stream().flatMap(ghost -> ghost.files().stream()).toList(),
        ghosts.stream().flatMap(ghost -> ghost.note().stream()).toList());
  }

  /** A ghost on its grid in the world of the scene, and what the user should know. */
  private record Ghost(Segment segment, VoxelGrid grid, List<Path> files, Optional<String> note) {}

  /** The file of a ghost, and which of its voxels are solid; {@code isAll} without a rule. */
  private record Source(String text, Path file, SegmentSpec spec, boolean isAll) {
    /** Takes what follows a colon as a rule if it is one, and else as a part of the file's name. */
    static Source parse(String text, String name) throws VolumeFormatException {
      for (int colon = text.indexOf(':'); colon > 0; colon = text.indexOf(':', colon + 1)) {
        Optional<SegmentSpec> rule = rule(name, text.substring(colon + 1));
        if (rule.isPresent()) {
          return new Source(text, path(text, colon), rule.get(), false);
        }
      }
      for (int colon = text.indexOf(':'); colon > 0; colon = text.indexOf(':', colon + 1)) {
        if (!Files.exists(path(text, text.length())) && Files.exists(path(text, colon))) {
          throw new VolumeFormatException(
              "the voxels of the ghost are not understood",
              "--ghost " + text,
              "write FILE, 'FILE:>=1500', FILE:300..900, FILE:label:7 or FILE:name:Mandible");
        }
      }
      return new Source(text, path(text, text.length()), SegmentSpec.nonzero(name), true);
    }

    private static Optional<SegmentSpec> rule(String name, String text) {
      try {
        return Optional.of(SegmentSpec.parse(name + "=" + text));
      } catch (VolumeFormatException e) {
        return Optional.empty();
      }
    }

    private static Path path(String text, int end) throws VolumeFormatException {
      try {
        return Path.of(text.substring(0, end));
      } catch (InvalidPathException e) {
        throw new VolumeFormatException(
            "this is no name of a file", "--ghost " + text, "name a volume file or a mesh", e);
      }
    }

    /** Reads what a closed mesh encloses, as voxels of 1/256 of its longest side. */
    Ghost readMesh(CoordinateSystem world) throws VolumeFormatException {
      if (!isAll) {
        throw new VolumeFormatException(
            "a mesh has no values to choose from", "--ghost " + text, "name the mesh alone");
      }
      MeshBody mesh = MeshBody.read(file, world, 0);
      Segment segment = new Segment(spec.name(), mesh.solid().bits(), RGB);
      return new Ghost(segment, mesh.solid().grid(), List.of(file), mesh.note());
    }

    Ghost readVolume(CoordinateSystem world) throws VolumeFormatException {
      VolumeReader reader = VolumeFiles.open(file, ReadOptions.defaults());
      VoxelGrid grid = reader.header().grid();
      Optional<VoxelGrid> turned =
          AxisSigns.convert(grid, reader.header().coordinateSystem(), world);
      Optional<String> note =
          turned.isEmpty()
              ? Optional.of(BodyReader.unknownAxes(reader.sourceName()))
              : Optional.empty();
      return new Ghost(segment(reader), turned.orElse(grid), reader.files(), note);
    }

    private Segment segment(VolumeReader reader) throws VolumeFormatException {
      SegmentSpec resolved = resolved(reader).withRgb(RGB);
      Segment segment = SegmentBuilder.read(reader, List.of(resolved)).segments().get(0);
      if (segment.bits().solidCount() == 0) {
        throw new VolumeFormatException(
            "the ghost has no voxel",
            "--ghost " + text,
            "palpate info --volume prints the values of a volume");
      }
      return segment;
    }

    private SegmentSpec resolved(VolumeReader reader) throws VolumeFormatException {
      try {
        return spec.resolved(reader.header().labels());
      } catch (VolumeFormatException e) {
        throw new VolumeFormatException(
            "the volume has no label of this name",
            "--ghost " + text,
            "choose one that palpate info prints, or write FILE:label:7",
            e);
      }
    }
  }
}
