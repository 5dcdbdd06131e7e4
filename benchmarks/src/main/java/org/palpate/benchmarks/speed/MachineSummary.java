package org.palpate.benchmarks.speed;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;

/** On what times were taken. */
final class MachineSummary {
  private MachineSummary() {}

  /** JDK, processor, number of processors, and how busy the machine was before anything ran. */
  static Map<String, Object> facts() {
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put(
        "java",
        System.getProperty("java.vm.name") + " " + System.getProperty("java.runtime.version"));
    facts.put("os", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
    facts.put("cpu", cpu());
    facts.put("processors", Runtime.getRuntime().availableProcessors());
    facts.put("load_before", ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    return facts;
  }

  /** The same as one line for a person. */
  static String line(Map<String, Object> facts) {
    return String.format(
        Locale.ROOT,
        "%s, %s, %s with %s processors, load %.1f before",
        facts.get("java"),
        facts.get("os"),
        facts.get("cpu"),
        facts.get("processors"),
        ((Number) facts.get("load_before")).doubleValue());
  }

  private static String cpu() {
    try (Stream<String> lines = Files.lines(Path.of("/proc/cpuinfo"), StandardCharsets.UTF_8)) {
      return lines
          .filter(line -> line.startsWith("model name"))
          .map(line -> line.substring(line.indexOf(':') + 1).trim())
          .findFirst()
          .orElse("unknown processor");
    } catch (IOException e) { // not Linux: the architecture must do
      return "unknown processor";
    }
  }
}
