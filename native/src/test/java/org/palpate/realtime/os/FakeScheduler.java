package org.palpate.realtime.os;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;

/** Records every call and answers each with the same error. */
final class FakeScheduler implements Scheduler {
  final List<String> calls = new ArrayList<>();
  private final String error;

  FakeScheduler(String error) {
    this.error = error;
  }

  @Override
  public String setRealtime(int tid, SchedulingClass schedulingClass, int priority) {
    calls.add((tid == 0 ? "" : tid + " ") + schedulingClass + " " + priority);
    return error;
  }

  @Override
  public String setAffinity(BitSet cpus) {
    calls.add("cpus " + CpuList.format(cpus));
    return error;
  }

  @Override
  public String lockMemory() {
    calls.add("lock");
    return error;
  }

  @Override
  public String setTimerSlack(long nanos) {
    calls.add("slack " + nanos);
    return error;
  }
}
