package org.palpate.benchmarks.elastic;

import java.util.List;
import org.palpate.benchmarks.stress.ExactJudge;
import org.palpate.geometry.Vec3;
import org.palpate.proxy.LegPath;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * Judges every leg of a chain exactly. One leg in {@link #LEGS_PER_CHECK} checks the judge itself:
 * decimal fractions alone decide it too, and a planted leg, which ends on the surface of a solid
 * voxel nearby, must be found. One thread.
 */
final class ElasticLegJudge {
  /** The number of legs of which one checks the judge. */
  static final int LEGS_PER_CHECK = 100;

  /** The largest distance along an axis to the voxel of a planted leg. */
  private static final int REACH_VOXELS = 3;

  private final ExactJudge judge = new ExactJudge();
  private final ExactJudge reference = ExactJudge.unfiltered();
  private final Vec3 end = new Vec3();
  private final Ray ray = new Ray();
  private final Ray planted = new Ray();
  private long legs;
  private long touching;
  private long broken;
  private long compared;
  private long differing;
  private long plantedLegs;
  private long plantedUnfound;

  /** Begins a new chain at a material point. */
  void begin(Vec3 point) {
    end.set(point);
  }

  /** Judges the legs of a frame, and whether they lead from the end of the last one to a point. */
  void judge(LegPath path, Vec3 point, List<BitCube> solids) {
    for (int leg = 0; leg < path.count(); leg++) {
      ray.from(path.start(leg, 0), path.start(leg, 1), path.start(leg, 2));
      ray.to(path.end(leg, 0), path.end(leg, 1), path.end(leg, 2));
      boolean begins = end.x == ray.fromX && end.y == ray.fromY && end.z == ray.fromZ;
      broken += begins ? 0 : 1;
      for (BitCube bits : solids) {
        judge(bits);
      }
      end.set(ray.toX, ray.toY, ray.toZ);
      legs++;
    }
    broken += end.sameBits(point) ? 0 : 1;
  }

  private void judge(BitCube bits) {
    boolean touches = judge.touches(bits, ray);
    touching += touches ? 1 : 0;
    if (legs % LEGS_PER_CHECK == 0) {
      compared++;
      differing += touches == reference.touches(bits, ray) ? 0 : 1;
      checkPlanted(bits);
    }
  }

  /**
   * Plants a leg to the nearest point of a solid voxel near the end of the ray, if there is one.
   */
  private void checkPlanted(BitCube bits) {
    int i = (int) Math.floor(ray.toX);
    int j = (int) Math.floor(ray.toY);
    int k = (int) Math.floor(ray.toZ);
    for (int z = k - REACH_VOXELS; z <= k + REACH_VOXELS; z++) {
      for (int y = j - REACH_VOXELS; y <= j + REACH_VOXELS; y++) {
        for (int x = i - REACH_VOXELS; x <= i + REACH_VOXELS; x++) {
          if (bits.get(x, y, z)) {
            planted.from(ray.fromX, ray.fromY, ray.fromZ);
            planted.to(nearest(ray.toX, x), nearest(ray.toY, y), nearest(ray.toZ, z));
            plantedLegs++;
            plantedUnfound += judge.touches(bits, planted) ? 0 : 1;
            return;
          }
        }
      }
    }
  }

  /** Returns the coordinate in a closed voxel that is nearest to another one. Exact. */
  private static double nearest(double coordinate, int voxel) {
    return Math.max(voxel, Math.min(voxel + 1.0, coordinate));
  }

  long legs() {
    return legs;
  }

  long touching() {
    return touching;
  }

  /** Returns how often a leg or a frame did not begin where the last one ended. */
  long broken() {
    return broken;
  }

  /** Returns the number of verdicts that decimal fractions alone gave too. */
  long compared() {
    return compared;
  }

  /** Returns the number of compared verdicts that differ. */
  long differing() {
    return differing;
  }

  long plantedLegs() {
    return plantedLegs;
  }

  /** Returns the number of planted legs that were not found to touch a solid. */
  long plantedUnfound() {
    return plantedUnfound;
  }
}
