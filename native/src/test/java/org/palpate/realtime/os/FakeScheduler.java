package org.palpate.realtime.os;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** Writes down what it is asked, and answers with one error to all of it. */
final class FakeScheduler implements Scheduler {
  final List<String> asked = new ArrayList<>();
  private final String error;

  FakeScheduler(String error) {
    this.error = error;
  }

  @Override
  public String setRealtime(int tid, SchedulingClass schedulingClass, int priority) {
    asked.add((tid == 0 ? "" : tid + " ") + schedulingClass + " " + priority);
    return error;
  }

  @Override
  public String setAffinity(BitSet cpus) {
    asked.add("cpus " + CpuList.format(cpus));
    return error;
  }

  @Override
  public String lockMemory() {
    asked.add("lock");
    return error;
  }

  @Override
  public String setTimerSlack(long nanos) {
    asked.add("slack " + nanos);
    return error;
  }
}
