package org.palpate.fracture;

import java.util.ArrayList;
import java.util.List;
import org.palpate.volume.fracture.PosedBits;

/**
 * Readings of all fragments of a bone. The largest fragment is the reference. The truth of a
 * synthetic fracture is the rest position of each fragment.
 *
 * @param residualMm largest displacement of a fragment's centroid from the truth, relative to the
 *     reference
 * @param residualDegrees largest rotation from the truth, relative to the reference
 * @param overlapVoxels pairs of voxels of different fragments whose interiors intersect
 * @param pairs the readings of each pair of fragments that face each other
 * @param overlaps the pairs of fragments that overlap
 */
public record FractureReadings(
    double residualMm,
    double residualDegrees,
    long overlapVoxels,
    List<Pair> pairs,
    List<Overlap> overlaps) {

  /**
   * Readings of two fragments.
   *
   * @param one the index of the fragment whose faces are measured
   * @param other the index of the fragment that it faces
   * @param readings gap, step-off and contact of the two
   */
  public record Pair(int one, int other, PairReadings readings) {}

  /**
   * Two fragments that overlap.
   *
   * @param one the index of one of them
   * @param other the index of the other
   * @param voxels the pairs of voxels whose interiors intersect, at least 1
   */
  public record Overlap(int one, int other, long voxels) {}

  /** Copies the lists. */
  public FractureReadings {
    pairs = List.copyOf(pairs);
    overlaps = List.copyOf(overlaps);
  }

  /**
   * {@return the readings of fragments at their poses}
   *
   * @param fragments every fragment of the bone, at least one
   */
  public static FractureReadings read(List<PosedBits> fragments) {
    PosedBits reference = fragments.get(0);
    for (PosedBits fragment : fragments) {
      reference =
          fragment.bits().solidCount() > reference.bits().solidCount() ? fragment : reference;
    }
    double residualMm = 0;
    double residualDegrees = 0;
    long overlap = 0;
    List<Pair> pairs = new ArrayList<>();
    List<Overlap> overlaps = new ArrayList<>();
    for (int one = 0; one < fragments.size(); one++) {
      Residual residual = Residual.fromRest(fragments.get(one), reference.pose());
      residualMm = Math.max(residualMm, residual.distanceMm());
      residualDegrees = Math.max(residualDegrees, residual.angleDegrees());
      for (int other = 0; other < one; other++) {
        PairReadings readings = PairReadings.read(fragments.get(one), fragments.get(other));
        overlap += readings.overlapVoxels();
        if (readings.isFacing()) {
          pairs.add(new Pair(one, other, readings));
        }
        if (readings.overlapVoxels() > 0) {
          overlaps.add(new Overlap(one, other, readings.overlapVoxels()));
        }
      }
    }
    return new FractureReadings(residualMm, residualDegrees, overlap, pairs, overlaps);
  }
}
