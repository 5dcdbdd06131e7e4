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
   * Returns the length by which the coupling weighs rotations against displacements, mm; 0 for a
   * point.
   */
  public double rotationRadiusMm() {
    return stiffnessNewtonPerMm > 0 ? Math.sqrt(rotationalStiffness / stiffnessNewtonPerMm) : 0;
  }

  /** Returns a world position in the frame's millimetres. */
  public Vec3 position(Vec3 worldMm) {
    return frameToWorld.inverseTransform(worldMm, new Vec3());
  }

  /** Returns a world direction along the frame's axes. */
  public Vec3 direction(Vec3 world) {
    return frameToWorld.inverseRotate(world, new Vec3());
  }
}
