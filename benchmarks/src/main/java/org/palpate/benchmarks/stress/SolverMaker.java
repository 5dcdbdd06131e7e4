package org.palpate.benchmarks.stress;

import org.palpate.proxy.Metric;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.smooth.SmoothSolver;

/** Makes a fresh solver for a scene. */
@FunctionalInterface
public interface SolverMaker {
  /** The smooth solver, whose measure of nearness is its own. */
  SolverMaker SMOOTH =
      new SolverMaker() {
        @Override
        public ProxySolver make(Metric metric, double maxStepMm) {
          return new SmoothSolver(metric, maxStepMm);
        }

        @Override
        public boolean endsNearer() {
          return false;
        }
      };

  ProxySolver make(Metric metric, double maxStepMm);

  /** Whether each frame has to end strictly nearer to the device or at the same bits. */
  default boolean endsNearer() {
    return true;
  }
}
