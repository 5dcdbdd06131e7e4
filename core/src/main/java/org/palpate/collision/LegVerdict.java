package org.palpate.collision;

/** The verdict on a leg, the exact segment between two points. Voxels are closed. */
public enum LegVerdict {
  /** The leg touches no solid voxel. */
  FREE,

  /** The leg touches a solid voxel. */
  HIT,

  /** Unknown; exact arithmetic decides. */
  DOUBT
}
