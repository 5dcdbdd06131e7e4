package org.palpate.benchmarks;

import java.io.IOException;
import java.io.InputStream;
import java.io.PrintStream;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
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
import org.palpate.loop.Median;
import org.palpate.volume.phantom.Phantom;

/**
 * Time to read a volume into a segment, against reading and inflating its bytes alone. The input is
 * the grey head phantom in a file, or the file that {@code -Dpalpate.volume} names.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1) // a second fork changes nothing: the work is one long loop, which compiles alike
@Warmup(iterations = 3, time = 1)
@Measurement(iterations = 5, time = 1)
public class VolumeReadBenchmark {
  private static final int BUFFER_BYTES = 1 << 16;
  private static final int ROUNDS = 15;

  /** The format, compressed by gzip or plain. */
  @Param({"nrrd", "nii.gz", "nii"})
  public String format;

  private Path file;
  private boolean made;

  /** Writes the phantom once per run, unless a file is named. */
  @Setup(Level.Trial)
  public void makeFile() throws IOException {
    String named = System.getProperty("palpate.volume", "");
    made = named.isEmpty();
    file = made ? Files.createTempFile("palpate-read", "." + format) : Path.of(named);
    if (made) {
      VolumeWriter.write(new PhantomReader(Phantom.parse("head:256:grey")), file);
    }
  }

  /** Deletes the file that was written. */
  @TearDown(Level.Trial)
  public void deleteFile() throws IOException {
    if (made) {
      Files.deleteIfExists(file);
    }
  }

  /** Reads the bytes of the file and inflates them if necessary: the least possible work. */
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

  /** Skips to the empty line that ends a NRRD header. */
  private static void skipHeader(InputStream in) throws IOException {
    for (int before = 0, c = in.read(); !(before == '\n' && c == '\n'); c = in.read()) {
      if (c < 0) {
        throw new UncheckedIOException(new IOException("no header"));
      }
      before = c;
    }
  }

  /** Decodes the slices and does nothing with them. */
  @Benchmark
  public long slices() throws IOException {
    long[] sum = {0};
    VolumeFiles.open(file, ReadOptions.defaults()).read((k, slice) -> sum[0] += slice.count());
    return sum[0];
  }

  /** Makes a segment of bits by a threshold. */
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

  /** A reading that {@link #main} measures. */
  private interface Reading {
    long run() throws IOException;
  }

  /**
   * Prints the processor time of each reading and its ratio to the bytes alone. The readings
   * alternate, so that a disturbance of the machine affects all alike. The arguments are formats to
   * make; none with {@code -Dpalpate.volume}.
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
    Map<String, Reading> readings = new LinkedHashMap<>();
    readings.put("bytes alone", this::bytesAlone);
    readings.put("slices", this::slices);
    readings.put("segment", this::segmentByThreshold);
    Map<String, double[]> nanos = new LinkedHashMap<>();
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    for (int round = 0; round < ROUNDS; round++) {
      for (Map.Entry<String, Reading> reading : readings.entrySet()) {
        long start = threads.getCurrentThreadCpuTime();
        reading.getValue().run();
        nanos.computeIfAbsent(reading.getKey(), any -> new double[ROUNDS])[round] =
            threads.getCurrentThreadCpuTime() - start;
      }
    }
    double alone = Median.of(nanos.get("bytes alone"));
    out.println(file.getFileName());
    nanos.forEach(
        (reading, rounds) ->
            out.printf(
                Locale.ROOT,
                "  %-12s %7.1f ms, %5.2f of the bytes alone%n",
                reading,
                Median.of(rounds) / 1e6,
                Median.of(rounds) / alone));
  }
}
