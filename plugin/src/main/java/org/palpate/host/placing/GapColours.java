package org.palpate.host.placing;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import org.palpate.body.BodyGroups;
import org.palpate.fracture.fit.GapMap;
import org.palpate.geometry.Pose;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.SessionView;
import org.palpate.scene.SceneLoader;
import org.palpate.scene.SurfaceTint;
import org.palpate.scene.window.WindowInput;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Colours the fracture faces of a fragment by the width of the gap to the fragment opposite. In the
 * view of a session a key switches the colours of the fragment in hand on and off; {@link #show}
 * colours all fragments of a picture.
 *
 * <p>Voxels are read without a lock. One thread, except for the key.
 */
public final class GapColours {
  private static final int NONE = -1;

  private final SegmentedVolume fragments;
  private final GapMap map;
  private final SessionView view;
  private volatile boolean isWanted;

  /** The fragment that is coloured, and the poses for which it is. */
  private int coloured = NONE;

  private List<RigidTransform> seen = List.of();

  /** Creates the colours of a view. They are switched off. */
  GapColours(SegmentedVolume fragments, SessionView view) {
    this.fragments = fragments;
    this.view = view;
    map = map(fragments);
  }

  private static GapMap map(SegmentedVolume fragments) {
    return new GapMap(fragments.grids(), fragments.segments().stream().map(Segment::bits).toList());
  }

  /**
   * Adds the key that shows or hides the colours.
   *
   * @param input the keys of the window
   */
  public void addTo(WindowInput input) {
    input.onKey('g', "gap map: distance to the facing fracture face", () -> isWanted = !isWanted);
  }

  /**
   * Colours a fragment anew if the bodies have moved, or uncolours it if the colours are off.
   *
   * @param poses the present pose of each body, rest to present
   */
  void update(int fragment, List<RigidTransform> poses, BodyGroups groups) {
    int wanted = isWanted ? fragment : NONE;
    if (wanted != coloured && coloured != NONE) {
      int former = coloured;
      view.withSurfaces(surfaces -> surfaces.tint(former, Optional.empty()));
    }
    if (wanted != NONE && (wanted != coloured || !poses.equals(seen))) {
      Optional<SurfaceTint> tint =
          tint(
              map,
              wanted,
              other -> groups.moveTogether(wanted, other),
              poses,
              fragments.grid(wanted));
      view.withSurfaces(surfaces -> surfaces.tint(wanted, tint));
      seen = poses;
    }
    coloured = wanted;
  }

  /** Returns a line that explains the colours; none if they are off. */
  List<String> lines() {
    return coloured == NONE
        ? List.of()
        : List.of("gap map: purple 0 mm, blue 1, teal 2, green 3, yellow 4");
  }

  /**
   * Colours all fragments of a picture.
   *
   * @param surfaces the drawn surfaces, one for each fragment
   * @param fragments the fragments at rest, each on its own grid
   * @param poses the pose of each fragment, rest to present
   */
  public static void show(
      SceneLoader surfaces, SegmentedVolume fragments, List<RigidTransform> poses) {
    GapMap map = map(fragments);
    for (int n = 0; n < poses.size(); n++) {
      surfaces.tint(n, tint(map, n, other -> false, poses, fragments.grid(n)));
    }
  }

  private static Optional<SurfaceTint> tint(
      GapMap map,
      int fragment,
      IntPredicate movesAlong,
      List<RigidTransform> poses,
      VoxelGrid grid) {
    List<Pose> present = poses.stream().map(pose -> new Pose().set(pose)).toList();
    List<SurfaceTint.Sample> samples = new ArrayList<>();
    for (GapMap.Gap gap : map.measure(fragment, movesAlong, present)) {
      Vec3 at = grid.worldToGrid(gap.restMm(), new Vec3());
      samples.add(new SurfaceTint.Sample(at, gap.gapMm() / GapMap.MOST_MM));
    }
    return samples.isEmpty()
        ? Optional.empty()
        : Optional.of(SurfaceTint.of(samples, grid.spacingMm()));
  }
}
