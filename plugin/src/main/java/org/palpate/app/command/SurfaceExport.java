package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.app.process.OutputPaths;
import org.palpate.body.Placement;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.scene.surface.ObjFile;
import org.palpate.scene.surface.SurfaceFile;
import org.palpate.scene.surface.WeldedSurface;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * Writes the surfaces of segments: into one file, or into one for each segment. World axes are LPS
 * or RAS, as the file's header says; axes that the volume does not name stay unnamed.
 */
final class SurfaceExport {
  private final Path target;
  private final boolean isSeparate;

  /**
   * Creates an export.
   *
   * @param target ends in {@code .stl}, {@code .ply} or {@code .obj}
   * @param isSeparate whether each segment has a file of its own, named after target and segment
   */
  SurfaceExport(Path target, boolean isSeparate) {
    this.target = target;
    this.isSeparate = isSeparate;
  }

  /** Whether a name ends as the name of a surface file does. */
  static boolean isSurfaceName(Path file) {
    return SurfaceFile.isSurfaceName(file) || isObj(file);
  }

  private static boolean isObj(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".obj");
  }

  /** Returns every file that will be written, in the order of the segments. */
  List<Path> targets(List<Segment> segments) {
    List<Path> files = isSeparate ? separate(segments) : List.of(target);
    List<Path> all = new ArrayList<>(files);
    if (isObj(target)) {
      files.forEach(file -> all.add(materialsBeside(file)));
    }
    return all;
  }

  private List<Path> separate(List<Segment> segments) {
    String name = target.getFileName().toString();
    int dot = name.lastIndexOf('.');
    return OutputPaths.fileWords(segments).stream()
        .map(word -> name.substring(0, dot) + "-" + word + name.substring(dot))
        .map(target::resolveSibling)
        .toList();
  }

  private static Path materialsBeside(Path obj) {
    String name = obj.getFileName().toString();
    return obj.resolveSibling(name.substring(0, name.length() - ".obj".length()) + ".mtl");
  }

  /** Returns the surfaces where the bodies stand, in millimetres of the volume's grid. */
  static List<WeldedSurface> placed(
      List<WeldedSurface> surfaces, List<Placement> placements, SegmentedVolume rest) {
    RigidTransform gridMmToWorld = rest.grid().gridMmToWorld();
    List<WeldedSurface> placed = new ArrayList<>(surfaces);
    for (int n = 0; n < placements.size(); n++) {
      Pose pose = placements.get(n).pose();
      placed.set(n, surfaces.get(n).moved(pose, rest.grid(n).gridMmToWorld(), gridMmToWorld));
    }
    return placed;
  }

  /**
   * Writes the surfaces, and returns a line for each file.
   *
   * @param surfaces the surface of each segment
   */
  List<String> write(List<WeldedSurface> surfaces, SegmentedVolume volume, CoordinateSystem world) {
    RigidTransform pose = toNamedSpace(volume.grid().gridMmToWorld(), world);
    List<ObjFile.Group> groups = new ArrayList<>();
    for (int n = 0; n < surfaces.size(); n++) {
      Segment segment = volume.segments().get(n);
      groups.add(new ObjFile.Group(segment.name(), segment.rgb(), surfaces.get(n)));
    }
    List<String> lines = new ArrayList<>();
    if (!isSeparate) {
      lines.add(write(target, groups, pose, world));
      return lines;
    }
    List<Path> files = separate(volume.segments());
    for (int n = 0; n < groups.size(); n++) {
      boolean isEmpty = surfaces.get(n).triangleCount() == 0;
      lines.add(
          isEmpty
              ? "not written: segment " + groups.get(n).name() + " has no surface"
              : write(files.get(n), List.of(groups.get(n)), pose, world));
    }
    return lines;
  }

  private static String write(
      Path file, List<ObjFile.Group> groups, RigidTransform pose, CoordinateSystem world) {
    String space = space(world);
    List<WeldedSurface> surfaces = groups.stream().map(ObjFile.Group::surface).toList();
    try (AtomicFile out = new AtomicFile(file)) {
      if (isObj(file)) {
        Path materials = materialsBeside(file);
        String comment = SurfaceFile.comment(space);
        ObjFile.write(groups, pose, comment, materials.getFileName().toString(), out.stream());
        AtomicFile.write(materials, ObjFile.materials(groups));
      } else {
        WeldedSurface all = WeldedSurface.together(surfaces);
        SurfaceFile.write(all, pose, space, SurfaceFile.isStl(file), out.stream());
      }
      out.commit();
    } catch (IOException e) {
      throw OutputPaths.failed(file, e);
    }
    String content =
        String.format(
            Locale.ROOT,
            "%,d triangles of %s, in mm, %s",
            surfaces.stream().mapToInt(WeldedSurface::triangleCount).sum(),
            groups.size() == 1 ? "segment " + groups.get(0).name() : groups.size() + " segments",
            space.isEmpty() ? "axes not named by the volume" : "SPACE=" + space);
    return OutputPaths.written(file, content);
  }

  /** Returns the name of the axes in a header; empty if the volume does not name them. */
  private static String space(CoordinateSystem world) {
    return switch (world) {
      case LPS, LAS -> "LPS";
      case RAS -> "RAS";
      case UNKNOWN -> "";
    };
  }

  /** Returns a pose in LPS if the world is LAS, which surface files cannot name. */
  private static RigidTransform toNamedSpace(RigidTransform pose, CoordinateSystem world) {
    return world != CoordinateSystem.LAS
        ? pose
        : new RigidTransform(
            backward(pose.axisX()),
            backward(pose.axisY()),
            backward(pose.axisZ()),
            backward(pose.origin()));
  }

  private static Vec3 backward(Vec3 v) {
    return new Vec3(v.x, -v.y, v.z);
  }
}
