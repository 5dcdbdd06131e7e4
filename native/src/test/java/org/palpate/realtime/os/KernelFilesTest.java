package org.palpate.realtime.os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KernelFilesTest {
  /** The kernel gives each of these files whole to the first read and nothing to a second one. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "/proc/sys/kernel/sched_rt_runtime_us",
        "/proc/sys/kernel/sched_rt_period_us",
        "/proc/self/limits"
      })
  void readsWhatAnotherProgramReads(String file) throws Exception {
    assumeTrue(Files.exists(Path.of(file)), "skipped: no " + file + " here");
    Process other = new ProcessBuilder("cat", file).start();
    String text = new String(other.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(text.lines().findFirst(), KernelFiles.line(Path.of(file)));
  }

  @Test
  void aMissingFileHasNoLines() {
    assertEquals(0, KernelFiles.lines(Path.of("/no/such/file")).count());
  }
}
