package org.palpate.realtime.os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ThrottlingTest {
  @TempDir Path root;

  @Test
  void restsFiftyMillisecondsInEverySecondByDefault() throws IOException {
    limit("950000");
    Throttling throttling = Throttling.read(root);
    assertTrue(throttling.limits());
    assertEquals(50_000, throttling.restMicros());
    assertEquals(40_000_000, throttling.gapNanos());
  }

  @Test
  void doesNotLimitIfTheKernelSaysMinusOne() throws IOException {
    limit("-1");
    assertFalse(Throttling.read(root).limits());
    assertEquals(Long.MAX_VALUE, Throttling.read(root).gapNanos());
  }

  @Test
  void doesNotLimitWithoutTheKernelsFile() {
    assertFalse(Throttling.read(root).limits());
  }

  private void limit(String runtimeMicros) throws IOException {
    Path folder = Files.createDirectories(root.resolve("proc/sys/kernel"));
    Files.writeString(folder.resolve("sched_rt_runtime_us"), runtimeMicros + "\n");
    Files.writeString(folder.resolve("sched_rt_period_us"), "1000000\n");
  }
}
