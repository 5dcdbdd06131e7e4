package org.palpate.io.scene;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import org.palpate.geometry.Pose;

/**
 * A scene and the file that it was read from.
 *
 * @param scene the content
 * @param file the file, to which the names in the scene are relative
 */
public record OpenedScene(SceneFile scene, Path file) {

  /**
   * Returns the scene with its bodies at other poses, to be written to another file.
   *
   * @param poses the pose of each body, from rest to present, world mm
   * @param target the file to be written, to which the names are then relative
   */
  public SceneFile at(List<Pose> poses, Path target) {
    List<SceneBody> bodies = new ArrayList<>();
    for (SceneBody body : scene.bodies()) {
      bodies.add(body.at(seenFrom(target, body.source()), poses.get(bodies.size())));
    }
    return with(bodies, target);
  }

  /** Returns the scene with some of its bodies alone, by their numbers. */
  OpenedScene only(List<Integer> kept) {
    List<SceneBody> bodies = kept.stream().map(scene.bodies()::get).toList();
    return new OpenedScene(scene.with(bodies, scene.fills()), file);
  }

  /**
   * Returns the scene with its bodies as labels of one volume, the first as 1, and at other poses.
   * Fills stay in the volumes that they have.
   *
   * @param poses the pose of each body, from rest to present, world mm
   * @param volume the name of the volume, relative to the target
   */
  public SceneFile asLabels(List<Pose> poses, String volume, Path target) {
    List<SceneBody> bodies = new ArrayList<>();
    for (SceneBody body : scene.bodies()) {
      Pose pose = poses.get(bodies.size());
      bodies.add(body.asLabel(volume, bodies.size() + 1).at(volume, pose));
    }
    return with(bodies, target);
  }

  private SceneFile with(List<SceneBody> bodies, Path target) {
    List<SceneFill> fills =
        scene.fills().stream().map(fill -> fill.at(seenFrom(target, fill.source()))).toList();
    return scene
        .with(bodies, fills)
        .with(
            bodies,
            scene
                .tool()
                .map(tool -> tool.isFile() ? tool.with(seenFrom(target, tool.spec())) : tool));
  }

  /**
   * Returns a name that is relative to the scene's file as it is relative to another file. On
   * another drive it becomes absolute.
   */
  private String seenFrom(Path target, String name) {
    Path named = file.toAbsolutePath().resolveSibling(name).normalize();
    Path folder = target.toAbsolutePath().normalize().getParent();
    boolean isNear = Objects.equals(folder.getRoot(), named.getRoot());
    return (isNear ? folder.relativize(named) : named).toString().replace('\\', '/');
  }
}
