package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

/**
 * Runs a session through the kernel's own HID core, in an emulated virtual machine. It takes about
 * two minutes and therefore runs only with {@code -Dpalpate.nightly=qemu}.
 */
class KernelHidTest {
  private static final Path SCRIPT =
      Path.of("..", "native", "src", "test", "sh", "touch-uhid-in-qemu.sh");

  @Test
  void aDeviceOfTheKernelIsListedRefusedAndTouched() throws Exception {
    Assumptions.assumeTrue(
        "qemu".equals(System.getProperty("palpate.nightly")),
        "skipped: the kernel's uhid in qemu: ./palpate test -Dpalpate.nightly=qemu");
    List<String> command = new ArrayList<>(List.of("sh", SCRIPT.toString()));
    command.addAll(
        CommandRun.inOwnJvm(Path.of(System.getProperty("java.home")), List.of()).command());
    ProcessBuilder builder = new ProcessBuilder(command).redirectErrorStream(true);
    builder.environment().remove("LD_LIBRARY_PATH");
    Process process = builder.start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), said);
    assertTrue(said.contains("uhid in qemu: listed, refused, touched"), said);
    said.lines().filter(line -> line.startsWith("uhid_hid: ")).forEach(System.out::println);
  }
}
