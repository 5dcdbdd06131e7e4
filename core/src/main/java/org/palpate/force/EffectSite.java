package org.palpate.force;

import java.util.List;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;

/**
 * The frame that effects are made for.
 *
 * @param frameToWorld the transform from the frame's millimetres to the world: the identity for a
 *     rigid tool, and that of the grid for a point
 * @param stiffnessNewtonPerMm the stiffness of contact, N/mm
 * @param rotationalStiffness that of a rotation, N mm/rad; 0 for a point
 * @param maxForceNewton the longest force of the frame; infinity for no limit
 * @param points sample points of the tool, a few at most, in the tool frame, mm; a point has one,
 *     the origin
 */
public record EffectSite(
    RigidTransform frameToWorld,
    double stiffnessNewtonPerMm,
    double rotationalStiffness,
    double maxForceNewton,
    List<Vec3> points) {

  /** Copies the list. */
  public EffectSite {
    points = List.copyOf(points);
  }

  /**
   * {@return the lever of the coupling, mm: the square root of rotational stiffness over stiffness}
   * A rotation counts as its angle times the lever. A point has 0.
   */
  public double leverMm() {
    return stiffnessNewtonPerMm > 0 ? Math.sqrt(rotationalStiffness / stiffnessNewtonPerMm) : 0;
  }

  /**
   * {@return a position in the frame's millimetres}
   *
   * @param worldMm the position, world mm
   */
  public Vec3 position(Vec3 worldMm) {
    return frameToWorld.inverseTransform(worldMm, new Vec3());
  }

  /**
   * {@return a direction along the frame's axes}
   *
   * @param world the direction along the axes of the world, of any length
   */
  public Vec3 direction(Vec3 world) {
    return frameToWorld.inverseRotate(world, new Vec3());
  }
}
