package org.palpate.host;

import org.palpate.force.ForceSettings;
import org.palpate.geometry.Vec3;
import org.palpate.volume.VoxelGrid;

/**
 * The stiffness for a device without a maximum of its own, by the extent of the scene.
 *
 * <p>Scenes from 32 mm to 1 m have 0.5 N/mm. A hand moves less far in a smaller scene, so that its
 * stiffness grows: at 256 um it is 500 N/mm, and each voxel feels as in the same scan at 256 mm.
 */
final class DefaultStiffness {
  private static final double SMALLEST_USUAL_MM = 32;
  private static final double LARGEST_USUAL_MM = 1000;

  /** A scan of this extent is the model of how a small one feels. */
  private static final double MODEL_MM = 256;

  /** The growth below the usual extents, until a small scene feels as the model does. */
  private static final double GROWTH = 1.5;

  private DefaultStiffness() {}

  /** Returns the stiffness, N per mm of scan. */
  static double newtonPerMm(VoxelGrid grid) {
    Vec3 spacing = grid.spacingMm();
    double extentMm =
        Math.max(
            grid.sizeX() * spacing.x, Math.max(grid.sizeY() * spacing.y, grid.sizeZ() * spacing.z));
    return ForceSettings.DEFAULT_STIFFNESS_NEWTON_PER_MM * factor(extentMm);
  }

  private static double factor(double extentMm) {
    if (extentMm > LARGEST_USUAL_MM) {
      return LARGEST_USUAL_MM / extentMm;
    }
    double smaller = Math.max(1, SMALLEST_USUAL_MM / extentMm);
    return smaller == 1 ? 1 : Math.min(MODEL_MM / extentMm, Math.pow(smaller, GROWTH));
  }
}
