package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.app.options.SceneElasticity;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.body.BodyGroups;
import org.palpate.io.VolumeWriter;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.WriteFailedException;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.scene.PlacedVolume;
import org.palpate.io.scene.SceneFile;
import org.palpate.io.scene.SceneWriter;
import org.palpate.io.scene.TransformWriter;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.volume.SegmentedVolume;

/**
 * Writes bodies as a label volume, and their poses as a scene file or as transforms. Beside a scene
 * file, a table holds the locks and groups of the bodies, if there are any. If poses are written,
 * the volume holds the bodies at rest, and the scene file names it. Otherwise it holds them at
 * their present poses, as it always does if they have grids of their own.
 */
final class FragmentExport {
  private final Path labels;
  private final Optional<Path> scene;
  private final Optional<Path> transforms;

  /**
   * Creates an export.
   *
   * @param labels the label volume, or null if none is written
   * @param scene the scene file, which names the label volume, or the files of the bodies
   * @param transforms the folder of the transform files
   */
  FragmentExport(Path labels, Optional<Path> scene, Optional<Path> transforms) {
    this.labels = labels;
    this.scene = scene;
    this.transforms = transforms;
  }

  /** Whether poses are written. */
  boolean writesPoses() {
    return scene.isPresent() || transforms.isPresent();
  }

  /**
   * Checks the targets before any work is done.
   *
   * @param inputs files that must not be replaced
   * @param haveFiles whether the bodies come from files that a scene can name
   * @return the files whose names are known already
   */
  List<Path> checked(List<Path> inputs, boolean haveFiles) {
    if (scene.isPresent() && labels == null && !haveFiles) {
      throw PalpateException.wrongUse(
          "the bodies of the scene have no volume",
          "--save-scene " + scene.get(),
          "add --export FILE");
    }
    transforms.ifPresent(folder -> OutputPaths.checkedFolder("--save-transforms", folder));
    List<Path> files = new ArrayList<>(scene.stream().toList());
    scene.flatMap(SceneWriter::tableOf).ifPresent(files::add);
    files.forEach(file -> OutputPaths.checked("--save-scene", file, inputs));
    return files;
  }

  /**
   * Refuses a scene file that would name files without the cuts of a session.
   *
   * @throws PalpateException exit code 2, if the cut voxels would not be in a volume at rest
   */
  void requireCutVoxels(PlacedVolume bodies) {
    if (scene.isPresent() && !writesRest(bodies)) {
      throw PalpateException.wrongUse(
          "the saved scene would name files without the cuts",
          "--save-scene " + scene.get(),
          bodies.rest().hasOneGrid()
              ? "add --export FILE"
              : "leave it out, or take all bodies from one volume");
    }
  }

  private boolean writesRest(PlacedVolume bodies) {
    return labels != null && writesPoses() && bodies.rest().hasOneGrid();
  }

  /**
   * Writes everything that was asked for, and returns a line for each file or folder. A scene keeps
   * the locks and groups that lie beside the one that was read.
   */
  List<String> write(PlacedVolume bodies) throws IOException {
    Optional<BodyGroups> groups = scene.isPresent() ? bodies.groups() : Optional.empty();
    return write(bodies, groups, SceneElasticity.NONE);
  }

  /**
   * Writes everything that was asked for, as the other method does.
   *
   * @param groups the locks and groups of the bodies; empty if there are none
   * @param elasticity that of the bodies in a scene file, with its fills as they were at the start
   */
  List<String> write(PlacedVolume bodies, Optional<BodyGroups> groups, SceneElasticity elasticity)
      throws IOException {
    SceneElasticity elastic = elasticity.leftBy(bodies.rest());
    List<String> lines = new ArrayList<>();
    if (labels != null) {
      SegmentedVolume written = writesRest(bodies) ? bodies.rest() : bodies.present();
      if (writesRest(bodies)) {
        written = elastic.withFills(written);
      }
      String format = VolumeWriter.write(new SegmentsAsLabels(written, bodies.world()), labels);
      String which = writesRest(bodies) ? "; bodies at rest, as their poses are written" : "";
      lines.add(OutputPaths.written(labels, format + which));
      if (!writesRest(bodies)) {
        lines.addAll(bodies.cutOff());
      }
    }
    if (scene.isPresent()) {
      BodyGroups kept = groups.orElseGet(() -> BodyGroups.none(bodies.names().size()));
      Optional<Path> table = writeScene(bodies, kept, elastic, scene.get());
      lines.add(OutputPaths.written(scene.get(), "scene"));
      table.ifPresent(file -> lines.add(OutputPaths.written(file, "locks and attachments")));
    }
    if (transforms.isPresent()) {
      writeTransforms(bodies, transforms.get());
      lines.add(OutputPaths.written(transforms.get(), "transforms" + axes(bodies)));
    }
    return lines;
  }

  private static String axes(PlacedVolume bodies) {
    return bodies.world() == CoordinateSystem.UNKNOWN
        ? "; the axes are not named and are taken as LPS"
        : "";
  }

  /** Writes the scene, and returns the table of locks and groups, if there is one. */
  private Optional<Path> writeScene(
      PlacedVolume bodies, BodyGroups groups, SceneElasticity elastic, Path file) {
    try {
      return SceneWriter.replace(file, written(bodies, elastic, file), bodies.names(), groups);
    } catch (WriteFailedException e) {
      throw OutputPaths.failed(e.target(), e);
    } catch (IOException e) {
      throw OutputPaths.failed(file, e);
    }
  }

  private SceneFile written(PlacedVolume bodies, SceneElasticity elastic, Path file) {
    if (!writesRest(bodies)) {
      return bodies.sceneOfFiles(file);
    }
    Path folder = file.toAbsolutePath().normalize().getParent();
    Path relative = folder.relativize(labels.toAbsolutePath().normalize());
    String volume = relative.toString().replace('\\', '/');
    return elastic.of(bodies.sceneOfLabels(volume, file), volume);
  }

  private static void writeTransforms(PlacedVolume bodies, Path folder) {
    try {
      Files.createDirectories(folder);
      List<String> names = OutputPaths.fileWords(bodies.rest().segments());
      for (int n = 0; n < names.size(); n++) {
        AtomicFile.write(
            folder.resolve(names.get(n) + ".tfm"),
            TransformWriter.text(bodies.placements().get(n).pose(), bodies.world()));
      }
    } catch (IOException e) {
      throw OutputPaths.failed(folder, e);
    }
  }
}
