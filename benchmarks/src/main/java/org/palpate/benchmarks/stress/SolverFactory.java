package org.palpate.benchmarks.stress;

import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;

/** Creates a solver for a scene, and knows its promises. */
@FunctionalInterface
public interface SolverFactory {
  /** The largest number that was observed. Only its finiteness is proved. */
  int SMOOTH_FRAMES_TO_SETTLE = 64;

  /** Creates the smooth solver, which lowers a function of its own instead of the distance. */
  SolverFactory SMOOTH =
      new SolverFactory() {
        @Override
        public ProxySolver make(GridMetric metric, double maxStepMm) {
          return new SmoothSolver(metric, maxStepMm);
        }

        @Override
        public boolean endsNearer() {
          return false;
        }

        @Override
        public int framesToSettle() {
          return SMOOTH_FRAMES_TO_SETTLE;
        }
      };

  /** Creates a solver for a metric and w_max, mm. */
  ProxySolver make(GridMetric metric, double maxStepMm);

  /** Returns the work of the last frame; 0 if the solver does not count it. */
  default int steps(ProxySolver solver) {
    return solver instanceof GuardedSolver guarded ? guarded.steps() : 0;
  }

  /** Whether each frame must end strictly nearer to the device or at the same bits. */
  default boolean endsNearer() {
    return true;
  }

  /**
   * Returns the number of frames that a point may take beyond its path until it rests. Two
   * successive frames move at least w_max together. The first leaves a part unused only if a step
   * up needs more than that part, and then the second begins with that step. A frame that ends
   * because its work budget is spent may come between two such frames, and is counted separately.
   */
  default int framesToSettle() {
    return 2;
  }
}
