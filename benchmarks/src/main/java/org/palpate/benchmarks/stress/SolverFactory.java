package org.palpate.benchmarks.stress;

import org.palpate.geometry.GridMetric;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.smooth.SmoothSolver;

/** Makes a fresh solver for a scene. */
@FunctionalInterface
public interface SolverFactory {
  /** In practice; what is proved is only that there are finitely many. */
  int SMOOTH_FRAMES_TO_SETTLE = 64;

  /** The smooth solver, whose measure of nearness is its own. */
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

  ProxySolver make(GridMetric metric, double maxStepMm);

  /** The steps of the last frame, where the solver tells them. */
  default int steps(ProxySolver solver) {
    return solver instanceof GuardedSolver guarded ? guarded.steps() : 0;
  }

  /** Whether each frame has to end strictly nearer to the device or at the same bits. */
  default boolean endsNearer() {
    return true;
  }

  /**
   * Frames that a point may take beyond its path, until it rests. Two frames that follow each other
   * go at least w_max together: the first leaves a part unused only where a climb needed more than
   * that part, and then the second begins with that climb. A frame that worked enough and left the
   * rest to the next one goes as far as it goes, and may part two such frames: it is not in here.
   */
  default int framesToSettle() {
    return 2;
  }
}
