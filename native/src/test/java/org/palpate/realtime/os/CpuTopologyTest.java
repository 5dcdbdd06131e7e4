package org.palpate.realtime.os;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.BitSet;
import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CpuTopologyTest {
  @Test
  void readsRangesAndSingleProcessors() {
    assertEquals("{0, 1, 2, 5, 8, 9}", CpuList.parse("0-2,5,8-9\n").toString());
    assertEquals("0,1,2", CpuList.format(CpuList.parse("0-2")));
    assertTrue(CpuList.parse("\n").isEmpty());
  }

  @Test
  void theErrorNamesATextThatIsNoList() {
    IllegalArgumentException error =
        assertThrows(IllegalArgumentException.class, () -> CpuList.parse("0-x"));
    assertEquals("not a list of processors: text=0-x", error.getMessage());
  }

  @Test
  void prefersAnIsolatedProcessorThenATicklessOneThenTheHighest() {
    assertEquals(OptionalInt.of(2), choose("0-7", "2", "3-4", ""));
    assertEquals(OptionalInt.of(4), choose("0-7", "", "3-4", ""));
    assertEquals(OptionalInt.of(3), choose("0-7", "", "3-4", "4"));
    assertEquals(OptionalInt.of(7), choose("0-7", "", "", ""));
  }

  @Test
  void keepsTheLastProcessorUnlessItIsIsolated() {
    assertEquals(OptionalInt.empty(), choose("0", "", "", ""));
    assertEquals(OptionalInt.empty(), choose("0-1", "", "", "1"));
    assertEquals(OptionalInt.of(3), choose("3", "3", "", ""));
  }

  @Test
  void readsTheKernelsFiles(@TempDir Path root) throws IOException {
    Files.createDirectories(root.resolve("proc/self"));
    Files.createDirectories(root.resolve("sys/devices/system/cpu"));
    Files.writeString(root.resolve("proc/self/status"), "Name:\tx\nCpus_allowed_list:\t0-3\n");
    Files.writeString(root.resolve("sys/devices/system/cpu/isolated"), "3\n");
    Files.writeString(root.resolve("sys/devices/system/cpu/nohz_full"), "(null)\n");
    CpuTopology topology = CpuTopology.read(root);
    assertEquals("{0, 1, 2, 3}", topology.allowed().toString());
    assertEquals("3 isolated", topology.name(3));
    assertTrue(topology.tickless().isEmpty());
  }

  @Test
  void reportsKernelSettingsAsText(@TempDir Path root) throws IOException {
    assertEquals(
        Map.of("throttling", "none", "isolated_cpus", "none", "nohz_full_cpus", "none"),
        OperatingSystem.kernelSettings(root));
    Files.createDirectories(root.resolve("proc/sys/kernel"));
    Files.createDirectories(root.resolve("sys/devices/system/cpu"));
    Files.writeString(root.resolve("proc/sys/kernel/sched_rt_runtime_us"), "950000\n");
    Files.writeString(root.resolve("proc/sys/kernel/sched_rt_period_us"), "1000000\n");
    Files.writeString(root.resolve("sys/devices/system/cpu/isolated"), "2-3\n");
    Files.writeString(root.resolve("sys/devices/system/cpu/nohz_full"), "3\n");
    assertEquals(
        Map.of("throttling", "950 of 1000 ms", "isolated_cpus", "2,3", "nohz_full_cpus", "3"),
        OperatingSystem.kernelSettings(root));
  }

  private static OptionalInt choose(
      String allowed, String isolated, String tickless, String taken) {
    BitSet given = CpuList.parse(taken);
    return new CpuTopology(CpuList.parse(allowed), CpuList.parse(isolated), CpuList.parse(tickless))
        .choose(given);
  }
}
