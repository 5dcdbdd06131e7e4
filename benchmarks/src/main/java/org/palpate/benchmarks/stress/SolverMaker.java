package org.palpate.benchmarks.stress;

import org.palpate.proxy.Metric;
import org.palpate.proxy.ProxySolver;

/** Makes a fresh solver for a scene. */
public interface SolverMaker {
  ProxySolver make(Metric metric, double maxStepMm);
}
