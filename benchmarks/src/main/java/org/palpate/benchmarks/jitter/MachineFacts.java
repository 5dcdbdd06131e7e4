package org.palpate.benchmarks.jitter;

import java.util.LinkedHashMap;
import java.util.Map;
import org.palpate.benchmarks.report.MachineFiles;
import org.palpate.realtime.os.OperatingSystem;

/** Describes the machine for a report on jitter. */
final class MachineFacts {
  private MachineFacts() {}

  /** Returns facts by name, in the order of the report. */
  static Map<String, String> read() {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("processor", MachineFiles.processor().orElse(property("os.arch")));
    facts.put("processors", Integer.toString(Runtime.getRuntime().availableProcessors()));
    facts.put("hypervisor", isGuest() ? "yes" : "none seen");
    facts.put("memory", MachineFiles.field("/proc/meminfo", "MemTotal").orElse("unknown"));
    facts.put("system", property("os.name") + " " + property("os.version"));
    facts.put("kernel", MachineFiles.line("/proc/version").orElse("unknown"));
    boolean realtime = MachineFiles.line("/sys/kernel/realtime").orElse("0").equals("1");
    facts.put("realtime_kernel", realtime ? "yes" : "no");
    facts.put(
        "clock",
        MachineFiles.line("/sys/devices/system/clocksource/clocksource0/current_clocksource")
            .orElse("unknown"));
    facts.put("isolated_cpus", cpus("/sys/devices/system/cpu/isolated"));
    facts.put("nohz_full_cpus", cpus("/sys/devices/system/cpu/nohz_full"));
    facts.put(
        "realtime_throttling", OperatingSystem.kernelSettings().getOrDefault("throttling", "none"));
    facts.put("load_at_start", MachineFiles.line("/proc/loadavg").orElse("unknown"));
    return facts;
  }

  private static boolean isGuest() {
    return MachineFiles.field("/proc/cpuinfo", "flags").orElse("").contains(" hypervisor");
  }

  private static String cpus(String file) {
    return MachineFiles.line(file).filter(text -> !text.isEmpty()).orElse("none");
  }

  private static String property(String name) {
    return System.getProperty(name);
  }
}
