package org.palpate.fracture.fit;

import java.util.Arrays;
import org.palpate.fracture.SmoothedBits;
import org.palpate.geometry.Vec3;
import org.palpate.volume.fracture.PosedBits;

/**
 * Distances from the surface of a fragment to that of a ghost, such as the mirrored healthy side.
 * Each is measured at a point of the fragment along its normal, outwards or inwards. A point counts
 * if it meets the surface of the ghost near by. That surface has to look the same way there, and no
 * other part of the fragment may lie clearly nearer to it. So fracture faces, which lie inside a
 * ghost that is whole, do not count.
 *
 * @param meanMm mean distance; NaN if no point counts
 * @param mostlyMm the distance that 95 % of the points do not exceed, likewise; unlike the largest,
 *     it does not depend on a few points at the broken rim
 * @param largestMm largest distance, likewise
 * @param share the part of the fragment's surface that counts, 0 to 1
 */
public record GhostDistance(double meanMm, double mostlyMm, double largestMm, double share) {
  /** The largest distance that is found, mm. */
  public static final double MOST_MM = FragmentSurfaces.REACH_MM;

  private static final double MOSTLY = 0.95;

  /** The least cosine between the normals of both surfaces. */
  private static final double LEAST_COSINE = 0.8;

  /**
   * {@return the distances of a fragment where it stands} Some 30 us for each voxel of its surface.
   *
   * @param fragment a fragment where it stands
   * @param ghost the ghost where it stands
   */
  public static GhostDistance read(PosedBits fragment, PosedBits ghost) {
    FragmentSurface surface = FragmentSurface.of(fragment.bits(), fragment.grid());
    Search search = new Search(fragment, ghost);
    Vec3 point = new Vec3();
    Vec3 normal = new Vec3();
    double[] distances = new double[surface.points().size()];
    int counted = 0;
    for (int n = 0; n < distances.length; n++) {
      fragment.pose().transform(surface.points().get(n), point);
      fragment.pose().rotation.rotate(surface.normals().get(n), normal);
      double distance = search.distanceMm(point, normal);
      if (!Double.isNaN(distance)) {
        distances[counted++] = distance;
      }
    }
    return of(Arrays.copyOf(distances, counted), distances.length);
  }

  private static GhostDistance of(double[] distances, int points) {
    if (distances.length == 0) {
      return new GhostDistance(Double.NaN, Double.NaN, Double.NaN, 0);
    }
    Arrays.sort(distances);
    return new GhostDistance(
        Arrays.stream(distances).average().orElseThrow(),
        distances[(int) Math.ceil(MOSTLY * distances.length) - 1],
        distances[distances.length - 1],
        (double) distances.length / points);
  }

  /** {@return whether any point counts} */
  public boolean isNear() {
    return share > 0;
  }

  /** Searches the surface of a ghost on lines from the surface of a fragment, and back. */
  private static final class Search {
    private final SmoothedBits fragment;
    private final SmoothedBits ghost;
    private final double edgeMm;
    private final Vec3 there = new Vec3();
    private final Vec3 normalThere = new Vec3();
    private final Vec3 back = new Vec3();

    Search(PosedBits fragment, PosedBits ghost) {
      this.fragment = new SmoothedBits(fragment, FragmentSurface.SIGMA);
      this.ghost = new SmoothedBits(ghost, FragmentSurface.SIGMA);
      edgeMm = FragmentSurface.edgeMm(fragment.grid());
    }

    /** Returns the distance of a point of the fragment's surface; NaN if it does not count. */
    double distanceMm(Vec3 point, Vec3 normal) {
      if (!ghost.isNear(point, MOST_MM) || !ghost.surface(point, normal, MOST_MM, there)) {
        return Double.NaN;
      }
      ghost.occupancy(there, normalThere);
      double distance = there.sub(point, back).length();
      boolean counts =
          normalThere.dot(normal) >= LEAST_COSINE
              && fragment.surface(there, normalThere, MOST_MM, back)
              && there.sub(back, back).length() >= distance - edgeMm;
      return counts ? distance : Double.NaN;
    }
  }
}
