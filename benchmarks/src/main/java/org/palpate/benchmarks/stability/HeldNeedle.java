package org.palpate.benchmarks.stability;

import java.util.List;
import java.util.Optional;
import org.palpate.body.Body;
import org.palpate.force.EffectPlan;
import org.palpate.force.ToolProposal;
import org.palpate.force.needle.NeedleTissue;
import org.palpate.force.needle.NeedleTrack;
import org.palpate.geometry.Quaternion;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;
import org.palpate.rigid.tool.RigidTool;
import org.palpate.rigid.tool.RodShape;
import org.palpate.rigid.tool.ToolSampler;

/** A needle that is pushed upright into tissue over bone. */
record HeldNeedle() implements HeldTool {
  private static final double RADIUS_MM = 0.5;
  private static final double LENGTH_MM = 30;
  private static final double COVER_RADIUS_MM = 0.5;

  /** The layers of voxels of the bone. */
  private static final int BONE_LAYERS = 8;

  /** The layer at which the tissue ends; it begins on the bone. */
  private static final int TISSUE_TOP = 120;

  private static final Body BONE = SolidLayers.body("bone", BONE_LAYERS);

  /** Soft enough for the weakest device: puncture 0.5 N, cutting 0.1 N, shaft 0.02 N/mm. */
  private static final NeedleTissue TISSUE =
      new NeedleTissue(SolidLayers.bits(BONE_LAYERS, TISSUE_TOP), 0.5, 0.1, 0.02);

  @Override
  public String name() {
    return "needle";
  }

  @Override
  public double lengthMm() {
    return LENGTH_MM - 2 * RADIUS_MM;
  }

  @Override
  public RigidTool tool() {
    return ToolSampler.ofShape(RodShape.capsule(RADIUS_MM, lengthMm()), COVER_RADIUS_MM);
  }

  @Override
  public Body solid() {
    return BONE;
  }

  @Override
  public Quaternion orientation() {
    return new Quaternion();
  }

  @Override
  public Vec3 touchMm() {
    return SolidLayers.middleMm(TISSUE_TOP * TouchedShape.VOXEL_MM + LENGTH_MM / 2);
  }

  @Override
  public Optional<ToolProposal> proposal(RigidCoupling coupling) {
    Vec3 tip = new Vec3(0, 0, -LENGTH_MM / 2);
    double newtonPerMm = coupling.stiffnessNewtonPerMm();
    return Optional.of(new NeedleTrack(List.of(TISSUE), BONE.grid(), tip, LENGTH_MM, newtonPerMm));
  }

  @Override
  public List<EffectPlan> effects() {
    return List.of();
  }
}
