package org.palpate.realtime.os;

import java.nio.file.Path;
import java.util.BitSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;

/** The system that this process runs on, as far as it can be asked for real time. */
public final class OperatingSystem {
  private static final String OS = System.getProperty("os.name").toLowerCase(Locale.ROOT);
  private static final boolean LINUX = OS.startsWith("linux");
  private static final boolean WINDOWS = OS.startsWith("windows");
  private static final boolean WIDE = System.getProperty("sun.arch.data.model", "64").equals("64");

  /** Processors that threads of this process keep to themselves; guarded by the class. */
  private static final BitSet TAKEN_CPUS = new BitSet();

  /** The real-time priority that is asked for where no vendor's thread wants a lower one. */
  public static final int USUAL_PRIORITY = RealtimePriority.USUAL;

  private OperatingSystem() {}

  /**
   * Asks the system for all that is wished for the calling thread. Once in a thread, before its
   * first frame; never throws for want of a right or a library.
   *
   * @return every answer, in the order in which it was asked
   */
  public static List<RequestOutcome> apply(RealtimeRequest wish) {
    synchronized (TAKEN_CPUS) {
      try {
        return ask(wish);
      } catch (LinkageError e) {
        return List.of(
            RequestOutcome.refused("class", "no library for real time: " + e.getMessage()));
      }
    }
  }

  /** Whether this is a Linux whose C library can be called. */
  static boolean isLinux() {
    return LINUX && WIDE;
  }

  private static List<RequestOutcome> ask(RealtimeRequest wish) {
    if (isLinux()) {
      return new LinuxSetup(new LinuxScheduler(), Path.of("/"), TAKEN_CPUS).apply(wish);
    }
    if (WINDOWS && WIDE) {
      return new WindowsSetup(TAKEN_CPUS).apply(wish);
    }
    return List.of(RequestOutcome.refused("class", "not known how to ask " + OS));
  }

  /**
   * The processor that a thread of another process should be given, as {@link #apply} would choose
   * for the first of ours; empty where nothing would be left for the rest, or nothing is known.
   */
  public static OptionalInt preferredProcessor() {
    return CpuTopology.read(Path.of("/")).choose(new BitSet());
  }

  /** How much of a processor real-time threads may have, as {@code 950 of 1000 ms}. */
  public static String throttlingText() {
    return Throttling.read(Path.of("/")).inWords();
  }

  /**
   * What the system does by itself that bears on real time, in words by name: {@code throttling},
   * {@code isolated_cpus}, {@code nohz_full_cpus}; empty where it is no Linux.
   */
  public static Map<String, String> noticed() {
    return isLinux() ? noticed(Path.of("/")) : Map.of();
  }

  /** As above, under a tree that looks like {@code /}. */
  static Map<String, String> noticed(Path root) {
    CpuTopology topology = CpuTopology.read(root);
    Map<String, String> words = new LinkedHashMap<>();
    words.put("throttling", Throttling.read(root).inWords());
    words.put("isolated_cpus", CpuList.inWords(topology.isolated()));
    words.put("nohz_full_cpus", CpuList.inWords(topology.tickless()));
    return words;
  }

  /** The most punctual sleep that the system offers; the JDK's own where there is no better. */
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
