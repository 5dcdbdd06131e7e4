package org.palpate.benchmarks.speed;

import java.io.BufferedOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.palpate.benchmarks.input.RaySet;
import org.palpate.device.Trajectory;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.raycast.Ray;
import org.palpate.volume.BitCube;

/**
 * The port of the guarded frame and the exact ray cast to C++. The jar contains its source, which
 * is compiled with -O3 -march=native and without fused multiply-add. One call runs a whole
 * trajectory over the same bricks.
 */
final class CppPort {
  private static final String SOURCES = "/org/palpate/benchmarks/cpp/";
  private static final List<String> NAMES = List.of("rays.h", "guarded.h", "port.cpp");

  /** The device position of a frame. */
  private static final int POINTS_PER_FRAME = 1;

  /** The two ends of a ray. */
  private static final int POINTS_PER_RAY = 2;

  /**
   * The result of a run.
   *
   * @param hash the hash over every position, contact and number of legs, or over every hit; see
   *     {@link CppComparison}
   * @param doubts the number of rays that only Java's exact traversal can decide; if there are any,
   *     hashes may differ
   * @param nanosPerPass processor time of a frame or ray in each pass
   */
  record Outcome(long hash, long doubts, List<Double> nanosPerPass) {}

  private final Path program;
  private final Path input;

  private CppPort(Path program, Path input) {
    this.program = program;
    this.input = input;
  }

  /**
   * Compiles the port in a folder.
   *
   * @throws IOException if there is no g++ or it fails
   */
  static CppPort in(Path folder) throws IOException, InterruptedException {
    for (String name : NAMES) {
      copySource(name, folder);
    }
    Path program = folder.resolve("palpate-port");
    output(
        "g++",
        "-O3",
        "-march=native",
        "-ffp-contract=off",
        "-std=c++17",
        "-o",
        program.toString(),
        folder.resolve("port.cpp").toString());
    return new CppPort(program, folder.resolve("port.bin"));
  }

  private static void copySource(String name, Path folder) throws IOException {
    try (InputStream stream = CppPort.class.getResourceAsStream(SOURCES + name)) {
      if (stream == null) {
        throw new IOException("the jar has no " + SOURCES + name);
      }
      Files.copy(stream, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
    }
  }

  /** Follows a trajectory a number of times. */
  Outcome follow(BitCube bits, Trajectory trajectory, double maxStep, int passes)
      throws IOException, InterruptedException {
    double[] xyz = new double[3 * trajectory.size()];
    Vec3 device = new Vec3();
    for (int n = 0; n < xyz.length; n++) {
      xyz[n] = trajectory.position(n / 3, device).get(n % 3);
    }
    return run(bits, POINTS_PER_FRAME, maxStep, xyz, passes);
  }

  /** Casts all rays a number of times. */
  Outcome cast(BitCube bits, RaySet rays, int passes) throws IOException, InterruptedException {
    double[] ends = new double[6 * rays.count()];
    Ray ray = new Ray();
    for (int n = 0; n < rays.count(); n++) {
      rays.at(n, ray);
      double[] one = {ray.fromX, ray.fromY, ray.fromZ, ray.toX, ray.toY, ray.toZ};
      System.arraycopy(one, 0, ends, 6 * n, 6);
    }
    return run(bits, POINTS_PER_RAY, 1, ends, passes);
  }

  private Outcome run(BitCube bits, int pointsEach, double maxStep, double[] xyz, int passes)
      throws IOException, InterruptedException {
    write(bits, pointsEach, maxStep, xyz);
    String[] words =
        output(program.toString(), input.toString(), Integer.toString(passes))
            .trim()
            .split(" ", -1);
    Files.delete(input);
    List<Double> nanos = new ArrayList<>();
    for (String word : Arrays.asList(words).subList(2, words.length)) {
      nanos.add(Double.parseDouble(word));
    }
    return new Outcome(Long.parseUnsignedLong(words[0], 16), Long.parseLong(words[1]), nanos);
  }

  private static String output(String... command) throws IOException, InterruptedException {
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    process.getOutputStream().close();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new IOException(
          command[0] + " failed: " + text.lines().findFirst().orElse("no message"));
    }
    return text;
  }

  private void write(BitCube bits, int pointsEach, double maxStep, double[] xyz)
      throws IOException {
    int blocksX = (bits.bricksX() + 3) / 4;
    int blocksY = (bits.bricksY() + 3) / 4;
    int blocksZ = (bits.bricksZ() + 3) / 4;
    IntBox box = bits.bounds();
    try (DataOutputStream out =
        new DataOutputStream(new BufferedOutputStream(Files.newOutputStream(input), 1 << 20))) {
      putInts(out, bits.bricksX(), bits.bricksY(), bits.bricksZ());
      putInts(out, blocksX, blocksY, blocksZ);
      putInts(out, box.lowX, box.lowY, box.lowZ, box.highX, box.highY, box.highZ);
      int layer = bits.bricksX() * bits.bricksY();
      for (int n = 0; n < layer * bits.bricksZ(); n++) {
        putLong(
            out, bits.brick(n % bits.bricksX(), n / bits.bricksX() % bits.bricksY(), n / layer));
      }
      for (int n = 0; n < blocksX * blocksY * blocksZ; n++) {
        putLong(out, bits.block(n % blocksX, n / blocksX % blocksY, n / (blocksX * blocksY)));
      }
      putInts(out, xyz.length / 3, pointsEach);
      putLong(out, Double.doubleToRawLongBits(maxStep));
      for (double one : xyz) {
        putLong(out, Double.doubleToRawLongBits(one));
      }
    }
  }

  private static void putInts(DataOutputStream out, int... values) throws IOException {
    for (int value : values) {
      out.writeInt(Integer.reverseBytes(value)); // the port reads little-endian
    }
  }

  private static void putLong(DataOutputStream out, long value) throws IOException {
    out.writeLong(Long.reverseBytes(value));
  }
}
