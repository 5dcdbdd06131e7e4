package org.palpate.benchmarks.jitter.trace;

import java.util.List;

/** The kernel's counters of the whole machine during an experiment. */
public final class MachineActivity {
  private final List<MachineSample> samples;

  /**
   * Creates an activity from samples.
   *
   * @param samples by time; may be empty
   */
  MachineActivity(List<MachineSample> samples) {
    this.samples = List.copyOf(samples);
  }

  /**
   * Returns the time that the hypervisor stole between the sample before {@code from} and the one
   * after {@code to}.
   */
  long stolenBetween(long from, long to) {
    long before = samples.isEmpty() ? 0 : samples.get(0).stolenNanos();
    long after = before;
    for (MachineSample sample : samples) {
      if (sample.nanos() <= from) {
        before = sample.stolenNanos();
      }
      after = sample.stolenNanos();
      if (sample.nanos() >= to) {
        break;
      }
    }
    return after - before;
  }

  /** Returns the stolen fraction of all processor time, 0 to 1. */
  public double stolenFraction() {
    return fraction(true);
  }

  /** Returns the busy fraction of all processor time, 0 to 1. */
  public double busyFraction() {
    return fraction(false);
  }

  private double fraction(boolean stolen) {
    if (samples.size() < 2) {
      return 0;
    }
    MachineSample first = samples.get(0);
    MachineSample last = samples.get(samples.size() - 1);
    double lost = last.stolenNanos() - first.stolenNanos();
    double busy = last.busyNanos() - first.busyNanos();
    double all = lost + busy + last.idleNanos() - first.idleNanos();
    return all <= 0 ? 0 : (stolen ? lost : busy) / all;
  }
}
