package org.palpate.benchmarks.surface;

import java.io.IOException;
import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.input.Scans;
import org.palpate.benchmarks.report.Progress;
import org.palpate.benchmarks.report.StudyTable;
import org.palpate.loop.Median;
import org.palpate.scene.surface.AmbientOcclusion;
import org.palpate.scene.surface.CoarseVolume;
import org.palpate.scene.surface.DensityAmbientOcclusion;
import org.palpate.scene.surface.SurfaceBrick;
import org.palpate.scene.surface.SurfaceExtractor;
import org.palpate.scene.surface.SurfaceSource;

/** Extracts the surface of each scan on one thread, as the scene does, and writes a table. */
public final class SurfaceStudy {
  private static final double NANOS_PER_SECOND = 1e9;
  private static final double NANOS_PER_MS = 1e6;
  private static final double MEGA = 1e6;

  /** The size of a vertex on the card: three floats and four shorts. */
  private static final int CARD_BYTES_PER_VERTEX = 20;

  private static final int SHORT_INDEX_LIMIT = 1 << 16;

  private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
  private final SurfaceExtractor extractor = new SurfaceExtractor();
  private long triangles;
  private long vertices;
  private long heapBytes;
  private long cardBytes;

  private SurfaceStudy() {}

  /**
   * Measures all scans.
   *
   * @param data the folder of the scans
   * @param folder the output folder, created if missing
   * @param out receives the table
   * @param progress receives progress lines
   * @return the triangles of the last and largest scan
   */
  public static long run(Path data, Path folder, PrintWriter out, PrintWriter progress)
      throws IOException {
    Files.createDirectories(folder);
    SurfaceStudy study = new SurfaceStudy();
    study.row(data, Scans.NAMES.get(0)); // warm-up
    List<SurfaceRow> rows = new ArrayList<>();
    for (String name : Scans.NAMES) {
      Progress.to(progress).accept("surfaces: " + name);
      rows.add(study.row(data, name));
    }
    print(rows, out);
    StudyTable.SURFACES.write(folder, rows, SurfaceRow::cells);
    return rows.get(rows.size() - 1).triangles();
  }

  private SurfaceRow row(Path data, String name) throws IOException {
    Scans scan = Scans.read(data, name);
    long began = threads.getCurrentThreadCpuTime();
    SurfaceSource coarse = CoarseVolume.of(scan.bone(), 2).source(scan.spacingMm());
    make(coarse, AmbientOcclusion.NONE);
    double coarseSeconds = (threads.getCurrentThreadCpuTime() - began) / NANOS_PER_SECOND;
    long coarseTriangles = triangles;
    began = threads.getCurrentThreadCpuTime();
    AmbientOcclusion light = new DensityAmbientOcclusion(List.of(scan.bone()));
    double[] brickMs = make(SurfaceSource.ofBits(scan.bone(), scan.spacingMm()), light);
    double seconds = (threads.getCurrentThreadCpuTime() - began) / NANOS_PER_SECOND;
    return new SurfaceRow(
        name,
        scan.bone().solidCount(),
        triangles,
        vertices,
        seconds,
        heapBytes,
        cardBytes,
        coarseTriangles,
        coarseSeconds,
        Median.of(brickMs),
        Arrays.stream(brickMs).max().orElseThrow());
  }

  /** Extracts every brick and returns the time of each that is not empty, ms. */
  private double[] make(SurfaceSource source, AmbientOcclusion light) {
    triangles = 0;
    vertices = 0;
    heapBytes = 0;
    cardBytes = 0;
    double[] millis = new double[extractor.layout(source).count()];
    int count = 0;
    for (int brick = 0; brick < millis.length; brick++) {
      long began = threads.getCurrentThreadCpuTime();
      SurfaceBrick mesh = extractor.extract(source, light, brick);
      if (mesh != null) {
        millis[count++] = (threads.getCurrentThreadCpuTime() - began) / NANOS_PER_MS;
        add(mesh);
      }
    }
    return Arrays.copyOf(millis, count);
  }

  private void add(SurfaceBrick mesh) {
    triangles += mesh.triangleCount();
    vertices += mesh.vertexCount();
    heapBytes += mesh.bytes();
    int indexBytes = mesh.vertexCount() <= SHORT_INDEX_LIMIT ? Short.BYTES : Integer.BYTES;
    cardBytes += (long) CARD_BYTES_PER_VERTEX * mesh.vertexCount();
    cardBytes += 3L * indexBytes * mesh.triangleCount();
  }

  private static void print(List<SurfaceRow> rows, PrintWriter out) {
    out.printf(
        "%-22s %10s %10s %7s %8s %8s %10s %8s %8s %8s%n",
        "data",
        "voxels",
        "triangles",
        "CPU s",
        "heap MB",
        "card MB",
        "coarse",
        "CPU s",
        "brick ms",
        "most");
    for (SurfaceRow row : rows) {
      out.printf(
          Locale.ROOT,
          "%-22s %,10d %,10d %7.2f %8.1f %8.1f %,10d %8.3f %8.2f %8.2f%n",
          row.data(),
          row.voxels(),
          row.triangles(),
          row.cpuSeconds(),
          row.heapBytes() / MEGA,
          row.cardBytes() / MEGA,
          row.coarseTriangles(),
          row.coarseCpuSeconds(),
          row.brickMedianMs(),
          row.brickMaxMs());
    }
    out.flush();
  }
}
