package org.palpate.benchmarks.jitter.trace;

import java.util.List;

/** What the kernel counted about the whole machine while a cell ran. */
public final class MachineActivity {
  private final List<MachineSample> samples;

  /**
   * @param samples by time; may be empty
   */
  MachineActivity(List<MachineSample> samples) {
    this.samples = List.copyOf(samples);
  }

  /**
   * Time stolen by the hypervisor between the sample before {@code from} and the one after {@code
   * to}.
   */
  long stolenBetween(long from, long to) {
    long before = 0;
    long after = 0;
    for (MachineSample sample : samples) {
      if (sample.nanos() <= from || before == 0) {
        before = sample.stolenNanos();
      }
      after = sample.stolenNanos();
      if (sample.nanos() >= to) {
        break;
      }
    }
    return after - before;
  }

  /** Stolen time as a share of all of it, 0 to 1. */
  public double stolenShare() {
    return share(true);
  }

  /** The time that processors were busy as a share of all of it, 0 to 1. */
  public double busyShare() {
    return share(false);
  }

  private double share(boolean stolen) {
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
