package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Samples the kernel's counters of the whole machine in a thread of the command's process, so that
 * the measured JVM is not disturbed. Relies on {@link System#nanoTime} being one clock for all
 * processes, as on Linux.
 */
public final class MachineSampler implements AutoCloseable {
  private static final long INTERVAL_MILLIS = 20;
  private static final long NANOS_PER_TICK = 10_000_000; // USER_HZ is 100 on every Linux
  private static final Path KERNEL_COUNTERS = Path.of("/proc/stat");

  private final List<MachineSample> samples = new ArrayList<>();
  private final Thread thread = new Thread(this::run, "machine-sampler");
  private volatile boolean closed;

  /** Starts the thread. */
  public MachineSampler() {
    thread.setDaemon(true);
    thread.start();
  }

  private void run() {
    while (!closed) {
      sample();
      try {
        Thread.sleep(INTERVAL_MILLIS);
      } catch (InterruptedException e) {
        return;
      }
    }
  }

  private void sample() {
    try (var lines = Files.lines(KERNEL_COUNTERS)) {
      lines.findFirst().flatMap(line -> parse(System.nanoTime(), line)).ifPresent(samples::add);
    } catch (IOException e) {
      closed = true; // a system without these counters
    }
  }

  /**
   * Parses the first line of {@code /proc/stat}: ticks of user, nice, system, idle, iowait, irq,
   * softirq, steal.
   */
  static Optional<MachineSample> parse(long nanos, String line) {
    String[] words = line.trim().split("\\s+", -1);
    if (words.length < 9 || !words[0].equals("cpu")) {
      return Optional.empty();
    }
    long[] ticks = new long[8];
    for (int i = 0; i < ticks.length; i++) {
      ticks[i] = Long.parseLong(words[i + 1]);
    }
    long busy = ticks[0] + ticks[1] + ticks[2] + ticks[5] + ticks[6];
    long idle = ticks[3] + ticks[4];
    return Optional.of(
        new MachineSample(
            nanos, ticks[7] * NANOS_PER_TICK, busy * NANOS_PER_TICK, idle * NANOS_PER_TICK));
  }

  /** Stops the thread and writes the samples. */
  public void write(Path file) throws IOException {
    close();
    StringBuilder text = new StringBuilder("nanos,stolen_nanos,busy_nanos,idle_nanos\n");
    for (MachineSample sample : samples) {
      text.append(sample.nanos())
          .append(',')
          .append(sample.stolenNanos())
          .append(',')
          .append(sample.busyNanos())
          .append(',')
          .append(sample.idleNanos())
          .append('\n');
    }
    Files.writeString(file, text, StandardCharsets.UTF_8);
  }

  /** Reads a file of samples; none if the file does not exist. */
  public static MachineActivity read(Path file) throws IOException {
    if (!Files.exists(file)) {
      return new MachineActivity(List.of());
    }
    List<MachineSample> samples = new ArrayList<>();
    List<String> lines = Files.readAllLines(file);
    for (String line : lines.subList(1, lines.size())) {
      String[] words = line.split(",", -1);
      samples.add(
          new MachineSample(
              Long.parseLong(words[0]),
              Long.parseLong(words[1]),
              Long.parseLong(words[2]),
              Long.parseLong(words[3])));
    }
    return new MachineActivity(samples);
  }

  @Override
  public void close() {
    closed = true;
    thread.interrupt();
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
