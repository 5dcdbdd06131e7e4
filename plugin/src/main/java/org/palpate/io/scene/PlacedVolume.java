package org.palpate.io.scene;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.palpate.body.BodyGroups;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.geometry.Pose;
import org.palpate.io.file.NumberText;
import org.palpate.io.table.GroupsCsv;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.fracture.Fragments;
import org.palpate.volume.fracture.PosedBits;

/**
 * Bodies at rest, each on its own grid, and their placements.
 *
 * @param rest a segment for each body, where it rests; its grid is that of the first volume
 * @param placements the placement of each body, in the same order
 * @param world the directions of the world axes
 * @param files the files that hold the bodies, which no output may replace
 * @param notes what the user should know, a sentence each
 * @param origin the scene file that names them; empty for fragments that no file names
 */
public record PlacedVolume(
    SegmentedVolume rest,
    List<Placement> placements,
    CoordinateSystem world,
    List<Path> files,
    List<String> notes,
    Optional<OpenedScene> origin) {

  /** Copies the lists. */
  public PlacedVolume {
    placements = List.copyOf(placements);
    files = List.copyOf(files);
    notes = List.copyOf(notes);
  }

  /**
   * Returns the fragments of a bone. The first, the largest, is fixed; the others are movable.
   *
   * @param poses the pose of each fragment, from its place in the bone, world mm
   */
  public static PlacedVolume ofFragments(
      Fragments fragments, List<Pose> poses, CoordinateSystem world) {
    List<Placement> placements = new ArrayList<>();
    for (Pose pose : poses) {
      placements.add(new Placement(placements.isEmpty() ? Mobility.FIXED : Mobility.MOVABLE, pose));
    }
    return new PlacedVolume(
        fragments.segments(), placements, world, List.of(), List.of(), Optional.empty());
  }

  /**
   * Returns segments as fixed bodies that stand where they rest.
   *
   * @param origin the scene that was read, whose bodies these are; empty if they are of none
   */
  public static PlacedVolume atRest(
      SegmentedVolume segments, CoordinateSystem world, Optional<OpenedScene> origin) {
    Placement fixed = new Placement(Mobility.FIXED, new Pose());
    return new PlacedVolume(
        segments,
        Collections.nCopies(segments.segments().size(), fixed),
        world,
        List.of(),
        List.of(),
        origin);
  }

  /**
   * Returns these bodies at other poses, with the same mobility.
   *
   * @param poses the pose of each body, from rest to present, world mm
   */
  public PlacedVolume at(List<Pose> poses) {
    List<Placement> moved = new ArrayList<>();
    for (Placement placement : placements) {
      moved.add(new Placement(placement.mobility(), poses.get(moved.size())));
    }
    return new PlacedVolume(rest, moved, world, files, notes, origin);
  }

  /** Returns these bodies with other voxels at rest. */
  public PlacedVolume with(SegmentedVolume newRest) {
    return new PlacedVolume(newRest, placements, world, files, notes, origin);
  }

  /** Returns the numbers of the bodies that have a voxel. */
  List<Integer> solid() {
    return IntStream.range(0, placements.size())
        .filter(n -> rest.segments().get(n).bits().solidCount() > 0)
        .boxed()
        .toList();
  }

  /** Returns some of these bodies alone, by their numbers. */
  PlacedVolume only(List<Integer> kept) {
    SegmentedVolume keptRest =
        new SegmentedVolume(
            rest.grid(),
            kept.stream().map(rest.segments()::get).toList(),
            kept.stream().map(rest::grid).toList());
    return new PlacedVolume(
        keptRest,
        kept.stream().map(placements::get).toList(),
        world,
        files,
        notes,
        origin.map(opened -> opened.only(kept)));
  }

  /**
   * Returns a scene that names the files of the scene that was read.
   *
   * @param target the file to which it will be written
   */
  public SceneFile sceneOfFiles(Path target) {
    return origin.orElseThrow().at(poses(), target);
  }

  /**
   * Returns a scene whose bodies are the labels of one volume, the first as 1.
   *
   * @param volume the name of the volume, relative to the target
   * @param target the file to which it will be written
   */
  public SceneFile sceneOfLabels(String volume, Path target) {
    return origin
        .map(opened -> opened.asLabels(poses(), volume, target))
        .orElseGet(() -> SceneFile.ofBodies(labels(volume)));
  }

  private List<SceneBody> labels(String volume) {
    List<SceneBody> bodies = new ArrayList<>();
    for (Segment segment : rest.segments()) {
      Placement placement = placements.get(bodies.size());
      String label = "label:" + (bodies.size() + 1);
      bodies.add(
          SceneBody.ofVolume(
              segment.name(), volume, label, placement.mobility(), placement.pose()));
    }
    return bodies;
  }

  /** Returns the names of the bodies, in their order. */
  public List<String> names() {
    return rest.segments().stream().map(Segment::name).toList();
  }

  /**
   * Reads the locks and groups that lie beside the scene that was read.
   *
   * @return empty if no scene was read, or it has none
   * @throws IOException if they are not understood
   */
  public Optional<BodyGroups> groups() throws IOException {
    Optional<Path> table = groupsFile();
    return table.isEmpty()
        ? Optional.empty()
        : GroupsCsv.read(table.get(), names(), this::isMovable);
  }

  /** Returns where the locks and groups of the scene that was read lie, if it has any. */
  public Optional<Path> groupsFile() {
    return origin.map(opened -> GroupsCsv.beside(opened.file()));
  }

  /** Whether the body of an index can move. */
  public boolean isMovable(int body) {
    return placements.get(body).mobility() == Mobility.MOVABLE;
  }

  /** Whether any body can move. */
  public boolean hasMovableBodies() {
    return IntStream.range(0, placements.size()).anyMatch(this::isMovable);
  }

  /** Whether a body that can move is not where it rests. */
  public boolean isDisplaced() {
    return placements.stream()
        .anyMatch(
            placement ->
                placement.mobility() == Mobility.MOVABLE && !placement.pose().sameBits(new Pose()));
  }

  /** Returns the poses, from rest to present, world mm. */
  public List<Pose> poses() {
    return placements.stream().map(Placement::pose).toList();
  }

  /**
   * Returns the placed bodies as segments of the grid of the first volume; see {@link
   * PosedBits#resample}. What lies outside that grid is missing.
   */
  public SegmentedVolume present() {
    return PosedBits.resample(rest, poses(), rest.grid());
  }

  /** Returns all notes, those of {@link #cutOff} too. */
  public List<String> exportNotes() {
    return Stream.concat(notes.stream(), cutOff().stream()).toList();
  }

  /** Returns a note for each body of which {@link #present} has not all. */
  public List<String> cutOff() {
    List<String> all = new ArrayList<>();
    List<PosedBits> bodies = PosedBits.of(rest, poses());
    for (int n = 0; n < bodies.size(); n++) {
      long outside = bodies.get(n).voxelsOutside(rest.grid());
      if (outside > 0) {
        all.add(
            NumberText.count((double) outside)
                + " of "
                + NumberText.count((double) bodies.get(n).bits().solidCount())
                + " voxels of "
                + rest.segments().get(n).name()
                + " lie outside the grid of the first volume, so an export leaves them out.");
      }
    }
    return all;
  }
}
