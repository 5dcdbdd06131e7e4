package org.palpate.app.command;

import java.nio.file.Path;
import java.util.Optional;
import org.palpate.app.options.VolumeSource;
import org.palpate.app.process.PalpateException;
import picocli.CommandLine.Option;

/** The options that write the poses of bodies. */
final class PoseOptions {
  @Option(
      names = "--save-scene",
      paramLabel = "FILE.json",
      description = {
        "Writes a scene file: the bodies of --scene or --phantom fracture where they stand at the"
            + " end, segments with their elasticity, or the fragments of --fracture, displaced."
            + " With --export it names that file, which then holds their voxels at rest, unless"
            + " they have several grids. Beside NAME.json, NAME.groups.csv holds locks and"
            + " attachments, if any."
      })
  private Path savedScene;

  @Option(
      names = "--save-transforms",
      paramLabel = "DIR",
      description = {
        "Writes the pose of each such body as an ITK transform, BODY.tfm: from rest to present,"
            + " LPS. With --export, that file holds their voxels at rest, to which the transforms"
            + " belong, unless they have several grids."
      })
  private Path savedTransforms;

  /** Returns the scene file to write; empty if none is written. */
  Optional<Path> scene() {
    return Optional.ofNullable(savedScene);
  }

  /**
   * Returns the export of bodies and their poses.
   *
   * @param labels the label volume, or null if none is written
   */
  FragmentExport export(Path labels) {
    return new FragmentExport(
        labels, Optional.ofNullable(savedScene), Optional.ofNullable(savedTransforms));
  }

  /**
   * Returns the export of the bodies of a volume and their poses.
   *
   * @param labels the label volume, or null if none is written
   * @param elastic whether segments are elastic, so that they make a scene
   * @throws PalpateException exit code 2, if poses are to be written but the volume has none
   */
  FragmentExport export(Path labels, VolumeSource source, boolean elastic) {
    FragmentExport bodies = export(labels);
    boolean isScene = source.placed().isPresent() || (elastic && savedTransforms == null);
    if (bodies.writesPoses() && !isScene) {
      throw PalpateException.wrongUse(
          "the volume has no bodies with poses",
          source.name(),
          "choose --scene or --phantom fracture");
    }
    return bodies;
  }
}
