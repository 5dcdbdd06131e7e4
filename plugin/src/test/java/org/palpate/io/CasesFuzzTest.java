package org.palpate.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.fail;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.io.volume.ReadOptions;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.testing.Scans;

/**
 * Damages each of the unusual files of {@code cases}: bytes are flipped and the end is cut off. A
 * damaged file is read, or refused in one line, with memory in proportion to its length. {@code
 * -Dpalpate.seed} repeats a run; a file that fails is kept in {@code target}.
 */
class CasesFuzzTest {
  private static final int DAMAGES = 120;
  private static final int MOST_FLIPS = 6;

  /** Decompression multiplies by a thousand, and a byte can become a double. */
  private static final long BYTES_PER_BYTE = 10_000;

  private static final long BYTES_ANYWAY = 64_000_000;

  @TempDir Path folder;

  @TestFactory
  Stream<DynamicTest> aDamagedFileIsReadOrRefusedInOneLine() throws IOException {
    Path cases = Scans.file("cases");
    String asked = System.getProperty("palpate.seed", "");
    long seed = asked.matches("-?[0-9]+") ? Long.parseLong(asked) : System.nanoTime();
    System.out.println("CasesFuzzTest seed " + seed);
    try (Stream<Path> files = Files.walk(cases)) {
      List<Path> samples =
          files
              .filter(Files::isRegularFile)
              .filter(f -> !f.getParent().equals(cases))
              .sorted()
              .toList();
      assumeTrue(!samples.isEmpty(), "skipped: no cases in " + cases);
      return samples.stream()
          .map(
              file ->
                  DynamicTest.dynamicTest(
                      cases.relativize(file).toString(), () -> damage(file, seed)));
    }
  }

  /** Damages a file in a copy of its folder, where the other files of a pair stay whole. */
  private void damage(Path file, long seed) throws IOException {
    Path copies = Files.createTempDirectory(folder, "case");
    try (Stream<Path> beside = Files.list(file.getParent())) {
      for (Path other : beside.filter(Files::isRegularFile).toList()) {
        Files.copy(other, copies.resolve(other.getFileName()));
      }
    }
    byte[] whole = Files.readAllBytes(file);
    Random random = new Random(seed ^ file.getFileName().toString().hashCode());
    Path copy = copies.resolve(file.getFileName());
    for (int n = 0; n < DAMAGES; n++) {
      byte[] damaged = damaged(whole, n, random);
      Files.delete(copy);
      Files.write(copy, damaged);
      requireReadOrRefused(copy, damaged, "damage " + n + " with seed " + seed);
    }
  }

  /** Cuts the end off in every third case, and else flips bits, mostly of the header. */
  private static byte[] damaged(byte[] whole, int n, Random random) {
    if (whole.length == 0 || n % 3 == 0) {
      return Arrays.copyOf(whole, random.nextInt(whole.length + 1));
    }
    byte[] damaged = whole.clone();
    int reach = n % 3 == 1 ? Math.min(400, whole.length) : whole.length;
    for (int flips = 1 + random.nextInt(MOST_FLIPS); flips > 0; flips--) {
      damaged[random.nextInt(reach)] ^= (byte) (1 + random.nextInt(255));
    }
    return damaged;
  }

  private static void requireReadOrRefused(Path file, byte[] bytes, String what)
      throws IOException {
    ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
    long thread = Thread.currentThread().getId();
    long before = threads.getThreadAllocatedBytes(thread);
    for (ReadOptions options :
        List.of(ReadOptions.defaults(), ReadOptions.defaults().withTimeStep(1))) {
      try {
        VolumeFiles.open(file, options).readLayers((k, slice) -> {});
      } catch (VolumeFormatException refused) {
        assertEquals(1, refused.getMessage().lines().count(), refused.getMessage());
      } catch (RuntimeException | Error e) {
        keep(file, bytes, what, e);
      }
    }
    long allocated = threads.getThreadAllocatedBytes(thread) - before;
    if (allocated > 2 * (BYTES_ANYWAY + BYTES_PER_BYTE * bytes.length)) {
      keep(file, bytes, what + " allocated " + allocated + " bytes", null);
    }
  }

  private static void keep(Path file, byte[] bytes, String what, Throwable cause)
      throws IOException {
    Path kept = Path.of("target", "fuzz-" + file.getFileName());
    Files.createDirectories(kept.getParent());
    Files.write(kept, bytes);
    fail(file.getFileName() + ", " + what + ", kept as " + kept, cause);
  }
}
