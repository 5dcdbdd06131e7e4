package org.palpate.raycast;

/** Opens the package-private factory of {@link ExactRayCaster} to the benchmarks. */
public final class ExactRayCasterVariants {
  private ExactRayCasterVariants() {}

  /** Returns a caster that passes no empty brick in one step. */
  public static ExactRayCaster voxelByVoxel() {
    return ExactRayCaster.voxelByVoxel();
  }
}
