package org.palpate.scene;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The contents of one picture: a copy for the renderer while the model goes on changing.
 *
 * @param objects visible segments
 * @param camera the camera
 * @param marks device, interaction point and force, if there are any
 * @param overlay lines of text in the upper left corner
 * @param help lines of text in the middle; none if the help is hidden
 * @param middle middle of all objects, scene frame, mm
 * @param radiusMm radius of a ball about the middle that contains all objects
 * @param detailMm largest distance between drawn surface and touched voxels
 * @param look theme, axes, stereo and slices
 * @param staticRevision changes with everything except marks and text
 * @param moving whether the camera is moving, so that speed matters more than detail
 * @param landmarks landmarks in the scene frame
 * @param legend the segments with their colours; empty if no legend is shown
 * @param clip hides the surfaces in front of it; empty if all are shown
 * @param deformation displaces what lies in the grid; empty if nothing is elastic
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
    List<NamedPoint> landmarks,
    List<LegendEntry> legend,
    Optional<ClipPlane> clip,
    Optional<Deformation> deformation) {

  /** Copies the lists. */
  public SceneState {
    objects = List.copyOf(objects);
    overlay = List.copyOf(overlay);
    help = List.copyOf(help);
    landmarks = List.copyOf(landmarks);
    legend = List.copyOf(legend);
  }

  /** Whether a ghost is drawn. */
  public boolean hasGhosts() {
    return objects.stream().anyMatch(DrawnObject::isGhost);
  }

  /** Returns where a point of a drawn surface is without the deformation, scene frame. */
  public Vec3 atRest(Vec3 presentMm) {
    if (deformation.isEmpty() || objects.isEmpty()) {
      return presentMm;
    }
    // What is elastic lies in one grid, so all objects have one pose.
    RigidTransform toScene = objects.get(0).pose();
    Vec3 gridMm = toScene.inverseTransform(presentMm, new Vec3());
    return toScene.transform(deformation.get().atRest(gridMm, new Vec3()), gridMm);
  }

  /**
   * A visible segment with its present appearance.
   *
   * @param pose transform from grid mm to the scene frame
   * @param tint colours a part of the surface
   * @param isGhost whether it is a ghost, which the mouse does not meet
   */
  public record DrawnObject(
      SceneObject object,
      int rgb,
      double opacity,
      RigidTransform pose,
      Optional<SurfaceTint> tint,
      boolean isGhost) {}

  /**
   * A segment in the legend.
   *
   * @param visible whether it is drawn
   * @param selected whether keys act on it
   */
  public record LegendEntry(String name, int rgb, boolean visible, boolean selected) {}

  /**
   * The general appearance.
   *
   * @param deformed colours deformed surfaces, if that is wanted
   */
  public record Look(
      Theme theme,
      WorldAxes axes,
      Stereo stereo,
      Optional<SlicePlanes> slices,
      Optional<DeformationColour> deformed) {
    /** Returns a copy with another stereo mode. */
    public Look with(Stereo other) {
      return new Look(theme, axes, other, slices, deformed);
    }

    /** Returns a copy with other slices. */
    public Look with(Optional<SlicePlanes> other) {
      return new Look(theme, axes, stereo, other, deformed);
    }

    /** Returns a copy with other colours of deformed surfaces. */
    public Look with(DeformationColour other) {
      return new Look(theme, axes, stereo, slices, Optional.of(other));
    }

    /** Returns a copy with the other theme. */
    public Look withOtherTheme() {
      Theme other = theme == Theme.DARK ? Theme.LIGHT : Theme.DARK;
      return new Look(other, axes, stereo, slices, deformed);
    }
  }
}
