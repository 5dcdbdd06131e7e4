package org.palpate.fracture.fit;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntPredicate;
import org.palpate.fracture.FaceLine;
import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Pose;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;
import org.palpate.volume.VoxelGrid;

/**
 * Measures the gap at each point of a fragment's fracture faces: the distance along the mean normal
 * of the face to what it faces. One thread an instance.
 */
public final class GapMap {
  /** The widest gap that is found, mm. */
  public static final double MOST_MM = FragmentSurfaces.REACH_MM;

  /** The largest depth of a face inside what it faces, mm. */
  private static final double DEEP_MM = 2;

  private final FragmentSurfaces surfaces;
  private final FaceLine line;

  /**
   * The gap at a point.
   *
   * @param restMm the point where the fragment rests, world mm; not to be written
   * @param gapMm the gap there; 0 where the surfaces meet
   */
  public record Gap(Vec3 restMm, double gapMm) {}

  /**
   * Prepares maps.
   *
   * @param grids the grid of each fragment
   * @param fragments the voxels of each fragment at rest
   */
  public GapMap(List<VoxelGrid> grids, List<BitCube> fragments) {
    surfaces = new FragmentSurfaces(grids, fragments);
    line = surfaces.faceLine();
  }

  /**
   * Measures a fragment; some 10 us for each of its facing points.
   *
   * @param fragment its index
   * @param movesAlong which fragments move along with it; they count as part of it
   * @param poses the pose of each fragment, from rest to present, world mm
   * @return the points that face another fragment
   */
  public List<Gap> measure(int fragment, IntPredicate movesAlong, List<Pose> poses) {
    List<Gap> gaps = new ArrayList<>();
    SmoothedBits own = surfaces.smoothed(fragment, poses);
    SmoothedBits[] faced = new SmoothedBits[poses.size()];
    Vec3 back = new Vec3();
    Vec3 start = new Vec3();
    for (FragmentSurfaces.FacingPoint each :
        surfaces.facing(n -> n == fragment || movesAlong.test(n), poses)) {
      int other = each.other();
      faced[other] = faced[other] == null ? surfaces.smoothed(other, poses) : faced[other];
      each.direction().mul(-1, back);
      if (each.fragment() == fragment && line.find(own, each.point(), back, -DEEP_MM, DEEP_MM)) {
        start.set(line.point());
        if (line.find(faced[other], start, each.direction(), -DEEP_MM, MOST_MM)) {
          Vec3 rest = surfaces.of(fragment).points().get(each.index());
          gaps.add(new Gap(rest, Math.max(0, line.distanceMm())));
        }
      }
    }
    return gaps;
  }
}
