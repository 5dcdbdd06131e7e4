package org.palpate.benchmarks.gpu;

import java.io.Closeable;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.palpate.benchmarks.report.MachineSummary;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.benchmarks.rigid.DeviceFrameTimes;
import org.palpate.benchmarks.rigid.LaunchCount;
import org.palpate.collision.LegBatch;
import org.palpate.opencl.OpenClCatalog;
import org.palpate.opencl.OpenClDevice;
import org.palpate.opencl.OpenClException;
import org.palpate.opencl.OpenClLegsVariants;
import org.palpate.volume.BitCube;

/**
 * Counts the launches that sliding tools need, and times the growth of solids by a clearance on the
 * CPU. Times how long it takes to judge 100 to 1,000,000 legs, none of which is culled: on one and
 * on two threads of the CPU, and on every OpenCL device. Times whole frames of sliding tools on
 * every OpenCL device and on the CPU in turn.
 */
public final class GpuRun {
  private static final String ONE_THREAD = "cpu 1 thread";
  private static final int[] POINTS = {100, 1_000, 10_000, 100_000, 1_000_000};
  private static final int QUICK_POINTS = 100_000;

  /** The number of legs that all frames of a row judge together, within the bounds below. */
  private static final double LEGS = 1e8;

  private static final double QUICK_LEGS = 1e7;

  /** Fewer frames would have no percentile of 99.9. */
  private static final int LEAST_FRAMES = 1_000;

  private static final int MOST_FRAMES = 20_000;
  private static final int GROWN_HEAD = 256;
  private static final int[] EDITED_EDGES = {1, 1 << BitCube.BRICK_SHIFT};
  private static final int STARTS = 30;
  private static final int SLIDE_FRAMES = 2_000;
  private static final int QUICK_SLIDE_FRAMES = 200;

  private final boolean quick;
  private final PrintWriter out;
  private final Consumer<String> progress;
  private final List<PartTime> times = new ArrayList<>();
  private final List<LaunchCount> launches = new ArrayList<>();
  private final List<List<Object>> frames = new ArrayList<>();

  /** Hits are summed so that no judging can be left out. */
  private long hits;

  private GpuRun(boolean quick, PrintWriter out, Consumer<String> progress) {
    this.quick = quick;
    this.out = out;
    this.progress = progress;
  }

  /**
   * Measures, prints, and writes a table.
   *
   * @param folder the output folder, created if missing
   * @param quick whether to run fewer frames, of at most 100,000 points
   * @param out receives the times
   * @param progress receives progress lines
   * @return the number of GPUs that were measured
   */
  public static long run(Path folder, boolean quick, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    out.println(MachineSummary.line(MachineSummary.facts()));
    GpuRun run = new GpuRun(quick, out, Progress.to(progress));
    run.countLaunches();
    StudyTable.GPU_LAUNCHES.write(folder, run.launches, GpuRun::cells);
    run.measureGrowth();
    run.measureCpu();
    // A device that fails does not cost the times before it, and is named even if writing fails.
    Closeable tables = () -> run.writeTimes(folder);
    long gpus;
    try (tables) {
      gpus = run.measureDevices();
    }
    out.println(gpus == 0 ? "No GPU was measured." : gpus + " GPUs were measured.");
    out.flush();
    return gpus;
  }

  private void writeTimes(Path folder) throws IOException {
    StudyTable.GPU.write(folder, times, PartTime::cells);
    StudyTable.GPU_FRAMES.write(folder, frames, cells -> cells);
  }

  private void countLaunches() {
    for (int n = 0; n < LaunchCount.conditions(); n++) {
      LaunchCount count = LaunchCount.of(n, quick ? QUICK_SLIDE_FRAMES : SLIDE_FRAMES);
      progress.accept(count.condition());
      launches.add(count);
      out.println(
          String.format(
              Locale.ROOT,
              "%-34s %4.2f motions a frame, %,7d / %,7d / %,7d legs left; launches a frame: alone"
                  + " %4.2f, together %4.2f, from %s legs on %s",
              count.condition(),
              count.motions(),
              count.legsP50(),
              count.legsP99(),
              count.legsMost(),
              count.alone(),
              count.together(),
              LaunchCount.COSTS,
              count.above()));
      out.flush();
    }
  }

  private static List<Object> cells(LaunchCount count) {
    List<Object> cells = new ArrayList<>();
    cells.add(count.condition());
    cells.add((long) count.points());
    cells.add(count.motions());
    cells.add(count.legsP50());
    cells.add(count.legsP99());
    cells.add(count.legsMost());
    cells.add(count.alone());
    cells.add(count.together());
    cells.addAll(count.above());
    return cells;
  }

  private int[] points() {
    return quick ? IntStream.of(POINTS).filter(n -> n <= QUICK_POINTS).toArray() : POINTS;
  }

  private int frames(int points) {
    double wanted = (quick ? QUICK_LEGS : LEGS) / points;
    return (int) Math.max(LEAST_FRAMES, Math.min(MOST_FRAMES, wanted));
  }

  private void measure(String device, int points, String part, Runnable run) {
    measure(device, points, part, frames(points), run);
  }

  private void measure(String device, int points, String part, int frames, Runnable run) {
    PartTime time = PartTime.measure(device, points, part, frames, run);
    times.add(time);
    out.println(
        String.format(
            Locale.ROOT,
            "%-24s %,9d points, %-10s least %,9.1f  p50 %,9.1f  p99 %,9.1f  p99.9 %,9.1f  max"
                + " %,9.1f us",
            device,
            points,
            part,
            time.least(),
            time.p50(),
            time.p99(),
            time.p999(),
            time.max()));
    out.flush();
  }

  private void measureGrowth() {
    progress.accept("growth by a clearance");
    for (int edge : EDITED_EDGES) {
      GrowthTimes growth = new GrowthTimes(GROWN_HEAD, edge);
      if (edge == 1) {
        measure(ONE_THREAD, growth.voxels(), "growth", STARTS, growth::growAll);
      }
      int voxels = edge * edge * edge;
      measure(ONE_THREAD, voxels, "growth after an edit", MOST_FRAMES, growth::growAfterEdit);
    }
  }

  private void measureCpu() {
    for (int points : points()) {
      progress.accept("CPU, " + points + " points");
      LegBatch all = OpenClLegsVariants.onCpu(points);
      measure(ONE_THREAD, points, "whole", () -> hits += TwoThreads.hits(all, points));
      int half = points / 2;
      LegBatch first = OpenClLegsVariants.onCpu(half);
      LegBatch second = OpenClLegsVariants.onCpu(half);
      try (TwoThreads two = new TwoThreads(first, second, half)) {
        measure("cpu 2 threads", points, "whole", () -> hits += two.judge());
      }
    }
    requireHits(hits);
  }

  private static void requireHits(long count) {
    if (count == 0) {
      throw new IllegalStateException("no leg near the ball touches it");
    }
  }

  private long measureDevices() {
    OpenClCatalog.Listing listing = OpenClCatalog.list();
    long gpus = 0;
    for (OpenClCatalog.Entry device : listing.devices()) {
      try {
        measureDevice(device);
        measureFrames(device);
        gpus += device.isGpu() ? 1 : 0;
      } catch (OpenClException e) {
        out.println(device.name() + " was not measured: " + e.getMessage());
      }
    }
    if (!listing.why().isEmpty()) {
      out.println("No OpenCL device was measured: " + listing.why());
    }
    return gpus;
  }

  private void measureDevice(OpenClCatalog.Entry device) throws OpenClException {
    for (int points : points()) {
      progress.accept(device.name() + ", " + points + " points");
      try (OpenClLegsVariants legs = new OpenClLegsVariants(device.name(), points)) {
        measure(device.name(), points, "round trip", legs::roundTrip);
        measure(device.name(), points, "launch", legs::launch);
        measure(device.name(), points, "transfer", legs::transfer);
        measure(device.name(), points, "reading", legs::read);
        measure(device.name(), points, "whole", legs::whole);
        measure(device.name(), points, "5 motions", legs::wholeOfSeveral);
        requireHits(legs.notFree());
      }
    }
  }

  /** Times frames of every tool, each with a device of its own, so that it keeps these voxels. */
  private void measureFrames(OpenClCatalog.Entry device) throws OpenClException {
    for (int n = 0; n < DeviceFrameTimes.conditions(); n++) {
      try (OpenClDevice judge = OpenClDevice.open(device.name())) {
        DeviceFrameTimes times =
            DeviceFrameTimes.of(n, judge, quick ? QUICK_SLIDE_FRAMES : SLIDE_FRAMES);
        progress.accept(device.name() + ", " + times.condition());
        frames.add(cells(device.name(), times));
        out.println(
            String.format(
                Locale.ROOT,
                "%-24s %-34s p50 %,7.1f us (CPU alone %,7.1f), p99.9 %,8.1f (%,8.1f), %4.2f"
                    + " launches a frame",
                device.name(),
                times.condition(),
                times.deviceP50(),
                times.cpuP50(),
                times.deviceP999(),
                times.cpuP999(),
                times.launches()));
        out.flush();
      }
    }
  }

  private static List<Object> cells(String device, DeviceFrameTimes times) {
    return List.of(
        device,
        times.condition(),
        (long) times.points(),
        times.cpuP50(),
        times.cpuP999(),
        times.deviceP50(),
        times.deviceP999(),
        times.launches());
  }
}
