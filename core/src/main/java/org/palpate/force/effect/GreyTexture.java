package org.palpate.force.effect;

import org.palpate.force.EffectSite;
import org.palpate.force.HandState;
import org.palpate.force.HapticEffect;
import org.palpate.geometry.Vec3;
import org.palpate.volume.ScalarVolume;
import org.palpate.volume.VoxelGrid;

/**
 * Lets the hand feel the detail of the grey values under the contact as bumps. The detail is the
 * grey value less the mean of those around it, and counts as a height. If the height rises in the
 * direction of motion, the pressing force pushes the hand back; if it falls, it pushes the hand
 * forwards.
 *
 * <p>The force is the pressing force times the slope, along the surface, and at most half the
 * pressing force. Of a rigid tool the detail at its reference point counts.
 *
 * <p>Reference: Minsky et al., Feeling and seeing: issues in force display, 1990. Haptic thread;
 * allocates nothing.
 */
final class GreyTexture implements HapticEffect {
  private static final double MOST_SLOPE = 0.5;

  private final ScalarVolume grey;
  private final VoxelGrid grid;
  private final double mmPerValue;
  private final EffectSite site;
  private final Vec3 at = new Vec3();
  private final Vec3 slope = new Vec3();
  private final Vec3 normal = new Vec3();

  /**
   * Creates an effect.
   *
   * @param mmPerValue the height of a unit of detail, mm
   */
  GreyTexture(ScalarVolume grey, double mmPerValue, EffectSite site) {
    this.grey = grey;
    this.mmPerValue = mmPerValue;
    this.site = site;
    grid = grey.grid();
  }

  @Override
  public void add(HandState hand, Vec3 forceNewton, Vec3 torqueNewtonMm) {
    double pressing = hand.contactNewton.length();
    if (!(pressing > 0)) {
      return;
    }
    site.frameToWorld().transform(hand.tool.translation, at);
    grid.worldToGrid(at, at);
    measureSlope();
    hand.contactNewton.mul(1 / pressing, normal);
    slope.sub(normal.mul(slope.dot(normal), normal), slope);
    double steep = slope.length();
    double factor = -pressing * (steep > MOST_SLOPE ? MOST_SLOPE / steep : 1);
    forceNewton.add(slope.mul(factor, slope), forceNewton);
  }

  /** Writes the slope of the detail at {@link #at}, along the frame's axes. */
  private void measureSlope() {
    Vec3 spacing = grid.spacingMm();
    slope.set(
        (detail(0.5, 0, 0) - detail(-0.5, 0, 0)) / spacing.x,
        (detail(0, 0.5, 0) - detail(0, -0.5, 0)) / spacing.y,
        (detail(0, 0, 0.5) - detail(0, 0, -0.5)) / spacing.z);
    slope.mul(mmPerValue, slope);
    grid.gridMmToWorld().rotate(slope, slope);
    site.frameToWorld().inverseRotate(slope, slope);
  }

  private double detail(double x, double y, double z) {
    double around =
        value(x + 1, y, z)
            + value(x - 1, y, z)
            + value(x, y + 1, z)
            + value(x, y - 1, z)
            + value(x, y, z + 1)
            + value(x, y, z - 1);
    return value(x, y, z) - around / 6;
  }

  /** Returns the grey value beside {@link #at}. */
  private double value(double x, double y, double z) {
    return grey.interpolated(at.x + x, at.y + y, at.z + z);
  }
}
