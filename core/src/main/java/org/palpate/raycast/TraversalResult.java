package org.palpate.raycast;

/** The answer of a floating-point traversal that stops as soon as rounding could matter. */
enum TraversalResult {
  /** The ray touches no solid voxel. */
  MISS,
  /** The ray touches a solid voxel, which the hit names. */
  HIT,
  /** Rounding could change the answer: {@link ExactRayCaster} must decide it exactly. */
  IN_DOUBT
}
