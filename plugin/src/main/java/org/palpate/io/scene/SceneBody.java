package org.palpate.io.scene;

import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.body.Mobility;
import org.palpate.geometry.Pose;

/**
 * A body of a scene file.
 *
 * @param name the name, unique in its scene
 * @param source the file that holds its voxels or triangles, as it is written: relative to the
 *     scene file, or absolute
 * @param isMesh whether the file is a mesh
 * @param segment the voxels of a volume as in {@code --segment} without the name; empty for a mesh,
 *     and for every voxel but 0
 * @param mobility whether and how it can move
 * @param pose the pose, from rest to present, world mm; not to be written
 * @param material stiffness, friction and damping as in {@code --material} without the name
 * @param youngPa the elastic modulus, Pa; present exactly for an elastic body
 * @param poisson the Poisson ratio of an elastic body
 */
public record SceneBody(
    String name,
    String source,
    boolean isMesh,
    Optional<String> segment,
    Mobility mobility,
    Pose pose,
    Optional<String> material,
    OptionalDouble youngPa,
    OptionalDouble poisson) {

  /** Returns a rigid body of a volume, without a material of its own. */
  public static SceneBody ofVolume(
      String name, String volume, String segment, Mobility mobility, Pose pose) {
    return new SceneBody(
        name,
        volume,
        false,
        Optional.of(segment),
        mobility,
        pose,
        Optional.empty(),
        OptionalDouble.empty(),
        OptionalDouble.empty());
  }

  /** Returns this body as an elastic one. */
  public SceneBody elastic(double youngPascal, double ratio) {
    return new SceneBody(
        name,
        source,
        isMesh,
        segment,
        Mobility.ELASTIC,
        pose,
        material,
        OptionalDouble.of(youngPascal),
        OptionalDouble.of(ratio));
  }

  /** Returns this body as a label of a volume, with the same mobility, pose and material. */
  SceneBody asLabel(String volume, int label) {
    return new SceneBody(
        name,
        volume,
        false,
        Optional.of("label:" + label),
        mobility,
        pose,
        material,
        youngPa,
        poisson);
  }

  /** Returns this body at another pose, with another name of the same file. */
  public SceneBody at(String newSource, Pose newPose) {
    return new SceneBody(
        name, newSource, isMesh, segment, mobility, newPose, material, youngPa, poisson);
  }
}
