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
import org.palpate.benchmarks.Trajectory;
import org.palpate.geometry.IntBox;
import org.palpate.geometry.Vec3;
import org.palpate.volume.BitCube;

/**
 * The guarded frame in C++, compiled from the source that the jar carries with -O3 -march=native
 * and no fused multiply-add, called once for a whole trajectory over the same bricks.
 */
final class CppTwin {
  private static final String SOURCE = "/org/palpate/benchmarks/cpp/twin.cpp";

  /**
   * What it found.
   *
   * @param hash over every position, contact and number of legs, see {@link CppTwinRun}
   * @param doubts rays that only Java's thorough walk could decide; where there are any, hashes may
   *     differ
   * @param nanosAFrame processor time of each pass
   */
  record Outcome(long hash, long doubts, List<Double> nanosAFrame) {}

  private final Path program;
  private final Path input;

  private CppTwin(Path program, Path input) {
    this.program = program;
    this.input = input;
  }

  /**
   * Compiles it in a folder.
   *
   * @throws IOException where there is no g++ or it fails
   */
  static CppTwin in(Path folder) throws IOException, InterruptedException {
    Path source = folder.resolve("twin.cpp");
    try (InputStream stream = CppTwin.class.getResourceAsStream(SOURCE)) {
      if (stream == null) {
        throw new IOException("the jar has no " + SOURCE);
      }
      Files.copy(stream, source, StandardCopyOption.REPLACE_EXISTING);
    }
    Path program = folder.resolve("palpate-twin");
    output(
        "g++",
        "-O3",
        "-march=native",
        "-ffp-contract=off",
        "-std=c++17",
        "-o",
        program.toString(),
        source.toString());
    return new CppTwin(program, folder.resolve("twin.bin"));
  }

  /** Runs a trajectory, so many times. */
  Outcome run(BitCube bits, Trajectory trajectory, double maxStep, int passes)
      throws IOException, InterruptedException {
    write(bits, trajectory, maxStep);
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
      throw new IOException(command[0] + " failed: " + text.lines().findFirst().orElse("no word"));
    }
    return text;
  }

  private void write(BitCube bits, Trajectory trajectory, double maxStep) throws IOException {
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
      putInts(out, trajectory.frames());
      putLong(out, Double.doubleToRawLongBits(maxStep));
      Vec3 device = new Vec3();
      for (int n = 0; n < 3 * trajectory.frames(); n++) {
        putLong(out, Double.doubleToRawLongBits(trajectory.at(n / 3, device).get(n % 3)));
      }
    }
  }

  private static void putInts(DataOutputStream out, int... values) throws IOException {
    for (int value : values) {
      out.writeInt(Integer.reverseBytes(value)); // the twin reads little-endian
    }
  }

  private static void putLong(DataOutputStream out, long value) throws IOException {
    out.writeLong(Long.reverseBytes(value));
  }
}
