package org.palpate.benchmarks.jitter;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.palpate.realtime.os.OperatingSystem;

/** What a reader must know of the machine that figures come from. */
final class MachineFacts {
  private MachineFacts() {}

  /** Facts by name, in the order in which a report tells them. */
  static Map<String, String> read() {
    Map<String, String> facts = new LinkedHashMap<>();
    facts.put("processor", field("/proc/cpuinfo", "model name").orElse(property("os.arch")));
    facts.put("processors", Integer.toString(Runtime.getRuntime().availableProcessors()));
    facts.put("hypervisor", isGuest() ? "yes" : "none seen");
    facts.put("memory", field("/proc/meminfo", "MemTotal").orElse("unknown"));
    facts.put("system", property("os.name") + " " + property("os.version"));
    facts.put("kernel", line("/proc/version").orElse("unknown"));
    facts.put(
        "realtime_kernel", line("/sys/kernel/realtime").orElse("0").equals("1") ? "yes" : "no");
    facts.put(
        "clock",
        line("/sys/devices/system/clocksource/clocksource0/current_clocksource").orElse("unknown"));
    facts.put(
        "isolated_cpus",
        line("/sys/devices/system/cpu/isolated").filter(s -> !s.isEmpty()).orElse("none"));
    facts.put(
        "nohz_full_cpus",
        line("/sys/devices/system/cpu/nohz_full").filter(s -> !s.isEmpty()).orElse("none"));
    facts.put("realtime_throttling", OperatingSystem.throttlingText());
    facts.put("load_at_start", line("/proc/loadavg").orElse("unknown"));
    return facts;
  }

  private static boolean isGuest() {
    return field("/proc/cpuinfo", "flags").orElse("").contains(" hypervisor");
  }

  private static Optional<String> field(String file, String name) {
    return text(file)
        .flatMap(text -> text.lines().filter(line -> line.startsWith(name)).findFirst())
        .map(line -> line.substring(line.indexOf(':') + 1).trim());
  }

  private static Optional<String> line(String file) {
    return text(file).map(text -> text.lines().findFirst().orElse("").trim());
  }

  private static Optional<String> text(String file) {
    try {
      return Optional.of(Files.readString(Path.of(file)));
    } catch (IOException e) {
      return Optional.empty(); // a system without this file
    }
  }

  private static String property(String name) {
    return System.getProperty(name);
  }
}
