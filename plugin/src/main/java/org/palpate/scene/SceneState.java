package org.palpate.scene;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * What one picture shows: a copy that the renderer reads while the model goes on.
 *
 * @param objects what is drawn of each segment
 * @param camera from where
 * @param marks the hand, where there is one
 * @param overlay lines of text in the upper left corner
 * @param help lines of text in the middle; none where the help is hidden
 * @param middle of all objects, scene frame, mm
 * @param radiusMm of a ball about the middle that holds all objects
 * @param detailMm how far a drawn surface may be from the voxels that are touched
 * @param look theme, axes, stereo, slices
 * @param staticRevision changes with everything but marks and text
 * @param moving whether the camera is being moved, so that speed counts more than detail
 * @param landmarks in the scene frame
 */
public record SceneState(
    List<DrawnObject> objects,
    Camera camera,
    Optional<TouchMarks> marks,
    List<String> overlay,
    List<String> help,
    Vec3 middle,
    double radiusMm,
    double detailMm,
    Look look,
    long staticRevision,
    boolean moving,
    List<NamedPoint> landmarks) {

  /** Copies the lists. */
  public SceneState {
    objects = List.copyOf(objects);
    overlay = List.copyOf(overlay);
    help = List.copyOf(help);
    landmarks = List.copyOf(landmarks);
  }

  /**
   * A segment as it is drawn now.
   *
   * @param pose from grid millimetres to the scene frame
   */
  public record DrawnObject(SceneObject object, int rgb, double opacity, RigidTransform pose) {}

  /** How it is drawn. */
  public record Look(Theme theme, WorldAxes axes, Stereo stereo, Optional<SlicePlanes> slices) {
    /** The same in another kind of stereo. */
    public Look with(Stereo other) {
      return new Look(theme, axes, other, slices);
    }

    /** The same with other slices. */
    public Look with(Optional<SlicePlanes> other) {
      return new Look(theme, axes, stereo, other);
    }

    /** The same, dark where it was light. */
    public Look withOtherTheme() {
      Theme other = theme == Theme.DARK ? Theme.LIGHT : Theme.DARK;
      return new Look(other, axes, stereo, slices);
    }
  }
}
