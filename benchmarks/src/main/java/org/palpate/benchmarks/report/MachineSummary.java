package org.palpate.benchmarks.report;

import java.lang.management.ManagementFactory;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;

/** Describes the machine on which times are measured. */
public final class MachineSummary {
  private MachineSummary() {}

  /**
   * Returns the JDK, the processor, the number of processors and the load before the measurement.
   */
  public static Map<String, Object> facts() {
    Map<String, Object> facts = new LinkedHashMap<>();
    facts.put(
        "java",
        System.getProperty("java.vm.name") + " " + System.getProperty("java.runtime.version"));
    facts.put("os", System.getProperty("os.name") + " " + System.getProperty("os.arch"));
    facts.put("cpu", MachineFiles.processor().orElse("unknown processor"));
    facts.put("processors", Runtime.getRuntime().availableProcessors());
    facts.put("load_before", ManagementFactory.getOperatingSystemMXBean().getSystemLoadAverage());
    return facts;
  }

  /** Returns the facts as one line for a person. */
  public static String line(Map<String, Object> facts) {
    return String.format(
        Locale.ROOT,
        "%s, %s, %s with %s processors, load %.1f before",
        facts.get("java"),
        facts.get("os"),
        facts.get("cpu"),
        facts.get("processors"),
        ((Number) facts.get("load_before")).doubleValue());
  }
}
