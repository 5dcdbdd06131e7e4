package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;

/** The facade of the operating system: real-time requests, precise sleep, kernel settings. */
public final class OperatingSystem {
  private static final String OS = System.getProperty("os.name").toLowerCase(Locale.ROOT);
  private static final boolean LINUX = OS.startsWith("linux");
  private static final boolean WINDOWS = OS.startsWith("windows");
  private static final boolean WIDE = System.getProperty("sun.arch.data.model", "64").equals("64");

  /** Processors that threads of this process have to themselves; guarded by itself. */
  private static final BitSet TAKEN_CPUS = new BitSet();

  /** The real-time priority that is requested unless a vendor's thread needs a lower one. */
  public static final int DEFAULT_PRIORITY = RealtimePriority.DEFAULT;

  private OperatingSystem() {}

  /**
   * Sends every request for the calling thread to the system. Call it once in a thread, before its
   * first frame. A missing right or library gives a denied outcome, not an exception.
   *
   * @return the outcomes, in the order of the requests
   */
  public static List<RequestOutcome> apply(RealtimeRequest request) {
    synchronized (TAKEN_CPUS) {
      try {
        return ask(request);
      } catch (LinkageError e) {
        return List.of(
            RequestOutcome.denied("class", "no library for real time: " + e.getMessage()));
      }
    }
  }

  /** Whether this is a 64-bit Linux, whose C library can be called. */
  public static boolean isLinux() {
    return LINUX && WIDE;
  }

  private static List<RequestOutcome> ask(RealtimeRequest request) {
    if (isLinux()) {
      return new LinuxSetup(new LinuxScheduler(), Path.of("/"), TAKEN_CPUS).apply(request);
    }
    if (WINDOWS && WIDE) {
      return new WindowsSetup(TAKEN_CPUS).apply(request);
    }
    return List.of(RequestOutcome.denied("class", "not known how to ask " + OS));
  }

  /**
   * Returns the processor that {@link #apply} would choose for the first thread, for use in another
   * process; empty if no processor would remain for everything else or if nothing is known.
   */
  public static OptionalInt preferredProcessor() {
    return CpuTopology.read(Path.of("/")).choose(new BitSet());
  }

  /**
   * Returns the kernel settings that affect real time, as text by name: {@code throttling}, {@code
   * isolated_cpus}, {@code nohz_full_cpus}; empty if the system is not Linux.
   */
  public static Map<String, String> kernelSettings() {
    return isLinux() ? kernelSettings(Path.of("/")) : Map.of();
  }

  /** Returns the settings read under {@code root} instead of {@code /}. */
  static Map<String, String> kernelSettings(Path root) {
    CpuTopology topology = CpuTopology.read(root);
    Map<String, String> settings = new LinkedHashMap<>();
    settings.put("throttling", Throttling.read(root).text());
    settings.put("isolated_cpus", CpuList.text(topology.isolated()));
    settings.put("nohz_full_cpus", CpuList.text(topology.tickless()));
    return settings;
  }

  /** Returns the most punctual sleep that the system offers; at worst the JDK's own. */
  public static PreciseSleep sleep() {
    try {
      if (isLinux()) {
        return new LinuxSleep();
      }
      if (WINDOWS && WIDE) {
        return new WindowsSleep();
      }
    } catch (LinkageError | UnsupportedOperationException e) {
      return new ParkSleep(); // an old Windows, or no C library that JNA can call
    }
    return new ParkSleep();
  }
}
