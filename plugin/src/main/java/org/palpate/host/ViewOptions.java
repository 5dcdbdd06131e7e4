package org.palpate.host;

import java.util.List;
import java.util.Optional;
import org.palpate.scene.ClipPlane;
import org.palpate.scene.DeformationColour;
import org.palpate.scene.MovableSlices;
import org.palpate.scene.surface.GreyRange;
import org.palpate.scene.window.ScenePanel;
import org.palpate.volume.SegmentedVolume;

/**
 * Options of a {@link SessionView} beyond surfaces made of bits.
 *
 * <p>Immutable. Start from {@link #PLAIN}.
 *
 * @param greys grey values for each segment whose surface follows them, in the order of the
 *     segments; missing ones at the end use the bits
 * @param slices planes of grey values with keys that switch and move them, if wanted
 * @param panel the component inside another program's window that shows the view; if empty, the
 *     view opens its own window
 * @param upsideDown whether the picture is turned by half a turn, for a file whose axes point the
 *     wrong way
 * @param threshold the segment whose threshold keys change, with the scene that touches it
 * @param axesFollowView whether the axes of a {@link org.palpate.device.WorkspaceDevice} are those
 *     of the picture; the world must then be right-handed
 * @param clip the plane that cuts the surfaces open at first, if wanted; keys turn it
 * @param deformed colours deformed surfaces, if that is wanted
 * @param ghosts segments that are drawn faintly and that nothing touches, if wanted; each stands
 *     where its grid puts it
 */
public record ViewOptions(
    List<Optional<GreyRange>> greys,
    Optional<MovableSlices.Start> slices,
    Optional<ScenePanel> panel,
    boolean upsideDown,
    Optional<Threshold> threshold,
    boolean axesFollowView,
    Optional<ClipPlane.Start> clip,
    Optional<DeformationColour> deformed,
    Optional<SegmentedVolume> ghosts) {

  /**
   * A segment whose threshold changes while it is touched.
   *
   * @param scene the scene that touches the segment
   * @param start the segment, its grey values and its first threshold
   * @param refusal the reason why the threshold must not change, which its keys show; empty if it
   *     may change
   */
  public record Threshold(ContactScene scene, LiveThreshold.Start start, String refusal) {}

  /** Surfaces made of bits, in a window of their own. */
  public static final ViewOptions PLAIN =
      new ViewOptions(
          List.of(),
          Optional.empty(),
          Optional.empty(),
          false,
          Optional.empty(),
          false,
          Optional.empty(),
          Optional.empty(),
          Optional.empty());

  /** Copies the list. */
  public ViewOptions {
    greys = List.copyOf(greys);
  }

  /**
   * {@return a copy that shows the view inside another program's window}
   *
   * @param component draws the view; the other program puts it into its window
   */
  public ViewOptions in(ScenePanel component) {
    return new ViewOptions(
        greys,
        slices,
        Optional.of(component),
        upsideDown,
        threshold,
        axesFollowView,
        clip,
        deformed,
        ghosts);
  }
}
