package org.palpate.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import java.util.zip.GZIPInputStream;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.TearDown;
import org.openjdk.jmh.annotations.Warmup;
import org.palpate.io.PhantomReader;
import org.palpate.io.VolumeFiles;
import org.palpate.io.VolumeWriter;
import org.palpate.io.label.SegmentBuilder;
import org.palpate.io.label.SegmentSpec;
import org.palpate.io.volume.ReadOptions;
import org.palpate.volume.phantom.Phantom;

/**
 * Reading a volume into a segment, against reading and inflating its bytes alone. The input is the
 * grey head phantom written to a file, or the file that {@code -Dpalpate.volume} names.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1) // a second fork changes nothing: the work is one long loop, compiled alike
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class VolumeReadBenchmark {
  private static final int BUFFER_BYTES = 1 << 16;
  private static final int ROUNDS = 15;

  /** Compressed by gzip, or plain. */
  @Param({"nrrd", "nii.gz", "nii"})
  public String format;

  private Path file;
  private boolean made;

  /** Writes the phantom, once a run, unless a file was named. */
  @Setup(Level.Trial)
  public void makeFile() throws IOException {
    String named = System.getProperty("palpate.volume", "");
    made = named.isEmpty();
    file = made ? Files.createTempFile("palpate-read", "." + format) : Path.of(named);
    if (made) {
      VolumeWriter.write(new PhantomReader(Phantom.parse("head:256:grey")), file);
    }
  }

  /** Deletes what was written. */
  @TearDown(Level.Trial)
  public void deleteFile() throws IOException {
    if (made) {
      Files.deleteIfExists(file);
    }
  }

  /** What cannot be avoided: the bytes of the file, inflated where it is gzip. */
  @Benchmark
  public long bytesAlone() throws IOException {
    byte[] buffer = new byte[BUFFER_BYTES];
    long sum = 0;
    try (InputStream in = inflated()) {
      for (int got = in.read(buffer); got >= 0; got = in.read(buffer)) {
        sum += got + buffer[0];
      }
    }
    return sum;
  }

  private InputStream inflated() throws IOException {
    InputStream in = Files.newInputStream(file);
    if (file.toString().endsWith(".nii")) {
      return in;
    }
    if (file.toString().endsWith(".nrrd")) {
      skipHeader(in);
    }
    return new GZIPInputStream(in, BUFFER_BYTES);
  }

  /** To the empty line that ends a NRRD header. */
  private static void skipHeader(InputStream in) throws IOException {
    for (int before = 0, c = in.read(); !(before == '\n' && c == '\n'); c = in.read()) {
      if (c < 0) {
        throw new UncheckedIOException(new IOException("no header"));
      }
      before = c;
    }
  }

  /** The slices decoded, and nothing done with them. */
  @Benchmark
  public long slices() throws IOException {
    long[] sum = {0};
    VolumeFiles.open(file, ReadOptions.defaults()).read((k, slice) -> sum[0] += slice.count());
    return sum[0];
  }

  /** A segment by threshold, as bits. */
  @Benchmark
  public long segmentByThreshold() throws IOException {
    return SegmentBuilder.read(
            VolumeFiles.open(file, ReadOptions.defaults()),
            List.of(SegmentSpec.atLeast("bone", 650)))
        .segments()
        .get(0)
        .bits()
        .solidCount();
  }

  /** One of the three, for {@link #main}. */
  private interface Way {
    long run() throws IOException;
  }

  /**
   * Processor time of each and ratios to the bytes alone, in turns, so that what else the machine
   * does falls on all alike. Takes the formats to make, or none with {@code -Dpalpate.volume}.
   */
  public static void main(String[] args) throws IOException {
    for (String format : args.length > 0 ? List.of(args) : List.of("nrrd")) {
      VolumeReadBenchmark benchmark = new VolumeReadBenchmark();
      benchmark.format = format;
      benchmark.makeFile();
      benchmark.compare(System.out);
      benchmark.deleteFile();
    }
  }

  private void compare(PrintStream out) throws IOException {
    Map<String, Way> ways = new LinkedHashMap<>();
    ways.put("bytes alone", this::bytesAlone);
    ways.put("slices", this::slices);
    ways.put("segment", this::segmentByThreshold);
    Map<String, long[]> nanos = new LinkedHashMap<>();
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    for (int round = 0; round < ROUNDS; round++) {
      for (Map.Entry<String, Way> way : ways.entrySet()) {
        long start = threads.getCurrentThreadCpuTime();
        way.getValue().run();
        nanos.computeIfAbsent(way.getKey(), any -> new long[ROUNDS])[round] =
            threads.getCurrentThreadCpuTime() - start;
      }
    }
    nanos.values().forEach(Arrays::sort);
    double alone = nanos.get("bytes alone")[ROUNDS / 2];
    out.println(file.getFileName());
    nanos.forEach(
        (way, sorted) ->
            out.printf(
                Locale.ROOT,
                "  %-12s %7.1f ms, %5.2f of the bytes alone%n",
                way,
                sorted[ROUNDS / 2] / 1e6,
                sorted[ROUNDS / 2] / alone));
  }
}
