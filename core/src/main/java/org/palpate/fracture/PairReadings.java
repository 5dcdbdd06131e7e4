package org.palpate.fracture;

import org.palpate.volume.fracture.PosedBits;

/**
 * Readings of two fragments that face each other across a fracture.
 *
 * @param gapMeanMm mean distance between the facing surfaces along the normal of the fracture
 * @param gapLargestMm largest such distance
 * @param stepOffMm displacement of the skins against each other across the fracture; NaN if too
 *     little skin lies on both sides
 * @param contactMm2 area whose gap is at most 0.6 of a voxel, seen along the normal
 * @param facingMm2 area of all facing surfaces, seen along the normal
 * @param overlapVoxels pairs of voxels whose interiors intersect
 */
public record PairReadings(
    double gapMeanMm,
    double gapLargestMm,
    double stepOffMm,
    double contactMm2,
    double facingMm2,
    long overlapVoxels) {
  /** The largest gap that counts as contact, shortest voxel edges. */
  private static final double CONTACT_EDGES = 0.6;

  /** {@return whether the fragments face each other at all} */
  public boolean isFacing() {
    return facingMm2 > 0;
  }

  /**
   * Reads two fragments. Some hundred milliseconds for fragments of 10,000 voxels.
   *
   * @param one a fragment where it stands
   * @param other another fragment where it stands
   * @return readings whose gaps are NaN and whose areas are 0 if the fragments do not face each
   *     other within about 4 mm
   */
  public static PairReadings read(PosedBits one, PosedBits other) {
    long overlap = new VoxelOverlap(one, other).count();
    FacingFaces faces = new FacingFaces(one, other);
    if (faces.isEmpty()) {
      return new PairReadings(Double.NaN, Double.NaN, Double.NaN, 0, 0, overlap);
    }
    double gap = faces.meanGapMm();
    double contactMm = CONTACT_EDGES * one.grid().metric().shortestEdgeMm();
    return new PairReadings(
        gap,
        faces.largestGapMm(),
        new StepOff(one, other, faces.normalWorld(), gap).measure(),
        faces.areaMm2(contactMm),
        faces.areaMm2(Double.POSITIVE_INFINITY),
        overlap);
  }
}
