package org.palpate.benchmarks.stability;

import java.util.List;
import org.palpate.benchmarks.stability.ClosedLoop.Outcome;

/** One set-up of the closed loop, which runs with any stiffness. */
public interface LoopTrial {
  /** Returns the device. */
  DeviceModel device();

  /** Returns the person. */
  Grip grip();

  /** Returns rate and delay. */
  Sampling sampling();

  /** Returns the cells of a table that distinguish this trial from others of its kind. */
  List<Object> conditionCells();

  /** Runs the trial with a stiffness, N/m. */
  Outcome run(double newtonPerM);
}
