package org.palpate.benchmarks.stability;

import java.util.List;

/** One set-up of the closed loop with something in hand that moves in six degrees of freedom. */
interface HeldTrial extends EnergyTrial {
  /** Returns the name of what is held, in tables. */
  String heldName();

  /** Returns the distance between the centres of a tool's caps, mm; 0 without caps. */
  double lengthMm();

  /** Returns the root mean square distance of its matter from its centre, mm. */
  double rmsRadiusMm();

  @Override
  default List<Object> conditionCells() {
    return List.of(heldName(), lengthMm(), rmsRadiusMm());
  }
}
