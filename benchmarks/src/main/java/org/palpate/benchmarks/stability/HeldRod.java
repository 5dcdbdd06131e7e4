package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.palpate.body.Body;
import org.palpate.force.EffectPlan;
import org.palpate.force.MassSettings;
import org.palpate.force.MassiveTool;
import org.palpate.force.ToolProposal;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;

/**
 * A rod that is held aslant over a flat wall, so that one end meets it first and the contact turns
 * the hand.
 *
 * @param name the name in tables
 * @param lengthMm the distance between the centres of the caps
 * @param massKg its mass, with inertia against motion and turning; empty without one
 * @param effects guides and effects that the hand feels
 */
record HeldRod(String name, double lengthMm, OptionalDouble massKg, List<EffectPlan> effects)
    implements HeldTool {
  private static final double RADIUS_MM = 3;
  private static final double TILT_RAD = 0.15;
  private static final double COVER_RADIUS_MM = 0.5;

  /** The layers of voxels of the wall. */
  private static final int WALL_LAYERS = SolidLayers.EDGE / 2;

  private static final Body WALL = SolidLayers.body("wall", WALL_LAYERS);

  /** Returns a rod without mass. */
  static HeldRod of(double lengthMm) {
    return new HeldRod("rod", lengthMm, OptionalDouble.empty(), List.of());
  }

  /** Returns a rod with mass. */
  static HeldRod of(double lengthMm, double kg) {
    return new HeldRod("rod of " + kg + " kg", lengthMm, OptionalDouble.of(kg), List.of());
  }

  /** Returns a rod with a guide or an effect. */
  static HeldRod of(double lengthMm, String feel, EffectPlan effect) {
    return new HeldRod("rod, " + feel, lengthMm, OptionalDouble.empty(), List.of(effect));
  }

  @Override
  public RigidTool tool() {
    return ToolSampler.ofShape(RodShape.capsule(RADIUS_MM, lengthMm), COVER_RADIUS_MM);
  }

  @Override
  public Body solid() {
    return WALL;
  }

  /** Returns the orientation of a rod that lies nearly flat on the wall. */
  @Override
  public Quaternion orientation() {
    return new Quaternion().setRotationVector(new Vec3(0, Math.PI / 2 - TILT_RAD, 0));
  }

  @Override
  public Vec3 touchMm() {
    double lowEndMm = 0.5 * lengthMm * Math.sin(TILT_RAD) + RADIUS_MM;
    return SolidLayers.middleMm(WALL_LAYERS * TouchedShape.VOXEL_MM + lowEndMm);
  }

  @Override
  public Optional<ToolProposal> proposal(RigidCoupling coupling) {
    if (massKg.isEmpty()) {
      return Optional.empty();
    }
    MassSettings mass = new MassSettings(massKg.getAsDouble(), new Vec3());
    return Optional.of(new MassiveTool(tool(), coupling, ClosedLoop.FRICTION, mass));
  }
}
