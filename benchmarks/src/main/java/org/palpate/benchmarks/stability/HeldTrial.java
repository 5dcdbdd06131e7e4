package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.force.EffectSite;
import org.palpate.frame.FrameSettings;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.rigid.RigidCoupling;

/** One set-up of the closed loop with something in hand that moves in six degrees of freedom. */
interface HeldTrial extends EnergyTrial {
  /** Returns the name of what is held, in tables. */
  String heldName();

  /** Returns the distance between the centres of a tool's caps, mm; 0 without caps. */
  double lengthMm();

  /** Returns the root mean square distance of its matter from its centre, mm. */
  double rmsRadiusMm();

  /** Returns the site of effects on what is held; its frame is the world. */
  static EffectSite site(RigidCoupling coupling, FrameSettings settings) {
    return new EffectSite(
        RigidTransform.identity(),
        coupling.stiffnessNewtonPerMm(),
        coupling.rotationalStiffness(),
        settings.maxForceNewton(),
        List.of(new Vec3()));
  }

  @Override
  default List<Object> conditionCells() {
    return List.of(heldName(), lengthMm(), rmsRadiusMm());
  }
}
