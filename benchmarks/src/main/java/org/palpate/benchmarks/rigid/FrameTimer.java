package org.palpate.benchmarks.rigid;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.PrintStream;
import java.lang.management.ManagementFactory;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.benchmarks.report.OwnProcess;
import org.palpate.geometry.Pose;
import org.palpate.loop.Median;

/**
 * Times the frames of every condition, in a process of its own. A frame is the solver's alone. Time
 * is the processor time of the thread, which other work on the machine hardly changes.
 */
final class FrameTimer {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();

  private FrameTimer() {}

  /**
   * The times of one condition.
   *
   * @param p50Us the median, us
   * @param p999Us the time that one frame in a thousand exceeds, us
   * @param bytes the fewest bytes that a quarter of the measured frames allocated; the JVM itself
   *     allocates a little when it links or compiles code that a frame has just met
   */
  record Times(double p50Us, double p999Us, double bytes) {}

  /** Prints a line with three numbers for each condition; arguments: warm-up and timed frames. */
  public static void main(String[] arguments) {
    int warmUp = Integer.parseInt(arguments[0]);
    int frames = Integer.parseInt(arguments[1]);
    PrintStream out = System.out;
    for (TimedCondition condition : TimedCondition.all()) {
      Times times = time(condition, warmUp, frames);
      out.println(times.p50Us + " " + times.p999Us + " " + times.bytes);
    }
  }

  /** Starts a process and returns the times of all conditions in order. */
  static List<Times> inProcessOfItsOwn(int warmUp, int frames)
      throws IOException, InterruptedException {
    List<String> arguments = List.of(Integer.toString(warmUp), Integer.toString(frames));
    return OwnProcess.lines(FrameTimer.class, List.of(), arguments).stream()
        .map(FrameTimer::parse)
        .toList();
  }

  private static Times parse(String line) {
    double[] numbers = Arrays.stream(line.split(" ")).mapToDouble(Double::parseDouble).toArray();
    return new Times(numbers[0], numbers[1], numbers[2]);
  }

  private static Times time(TimedCondition condition, int warmUp, int frames) {
    TimedCondition.Pressed pressed = condition.pressed();
    ToolRun run = pressed.run();
    PressAndSlide device = pressed.device();
    Pose pose = new Pose();
    for (int frame = 0; frame < warmUp; frame++) {
      run.follow(device.device(frame, pose));
    }
    double[] nanos = new double[frames];
    double fewest = Double.POSITIVE_INFINITY;
    for (int quarter = 0; quarter < 4; quarter++) {
      long allocated = THREADS.getCurrentThreadAllocatedBytes();
      for (int frame = quarter * frames / 4; frame < (quarter + 1) * frames / 4; frame++) {
        device.device(warmUp + frame, pose);
        long begin = THREADS.getCurrentThreadCpuTime();
        run.follow(pose);
        nanos[frame] = THREADS.getCurrentThreadCpuTime() - begin;
      }
      fewest = Math.min(fewest, (double) (THREADS.getCurrentThreadAllocatedBytes() - allocated));
    }
    return new Times(Median.of(nanos) / 1e3, Quantile.of(nanos, 0.999) / 1e3, fewest);
  }

  /** Returns the medians of the times over processes, and the fewest bytes. */
  static List<Times> medians(List<List<Times>> forks) {
    List<Times> medians = new ArrayList<>();
    for (int n = 0; n < forks.get(0).size(); n++) {
      int condition = n;
      List<Times> all = forks.stream().map(fork -> fork.get(condition)).toList();
      medians.add(
          new Times(
              Median.of(all.stream().mapToDouble(Times::p50Us).toArray()),
              Median.of(all.stream().mapToDouble(Times::p999Us).toArray()),
              all.stream().mapToDouble(Times::bytes).min().orElseThrow()));
    }
    return medians;
  }
}
