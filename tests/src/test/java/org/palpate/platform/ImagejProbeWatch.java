package org.palpate.platform;

import ij.IJ;
import java.awt.Dialog;
import java.awt.Window;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;

/** Conditions, threads and memory that {@link ImagejProbe} waits for and counts. */
final class ImagejProbeWatch {
  private static final long PATIENCE_NANOS = 90_000_000_000L;

  private ImagejProbeWatch() {}

  static void await(String what, BooleanSupplier condition) {
    long end = System.nanoTime() + PATIENCE_NANOS;
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > end) {
        throw new IllegalStateException("waited in vain for " + what);
      }
      pause(2);
    }
  }

  static void pause(long millis) {
    IJ.wait((int) millis);
  }

  static List<String> palpateThreads() {
    // JOGL names the threads that all windows share after the thread that opened the first one.
    return threadNames().stream()
        .filter(name -> name.startsWith("palpate") && !name.endsWith("SharedResourceRunner"))
        .toList();
  }

  static void awaitQuietThreads() {
    await("Palpate's threads to end", () -> palpateThreads().isEmpty());
  }

  /** Whether a thread of that name is alive; ImageJ names a thread after its command. */
  static boolean isAlive(String name) {
    return threadNames().contains(name);
  }

  /**
   * Returns the number of threads by name. It omits those that ImageJ starts for a macro, and the
   * one that the JDK keeps for a minute after a process has ended, which JogAmp starts once.
   */
  static Map<String, Long> threads() {
    return threadNames().stream()
        .filter(name -> !name.startsWith("Run$_") && !name.contains("Macro"))
        .filter(name -> !name.equals("process reaper"))
        .map(name -> name.replaceAll("[0-9]+", "N"))
        .collect(Collectors.groupingBy(name -> name, TreeMap::new, Collectors.counting()));
  }

  /** Returns the names with more threads than before. */
  static List<String> threadsMoreThan(Map<String, Long> before) {
    return threads().entrySet().stream()
        .filter(entry -> entry.getValue() > before.getOrDefault(entry.getKey(), 0L))
        .map(Object::toString)
        .toList();
  }

  private static List<String> threadNames() {
    return Thread.getAllStackTraces().keySet().stream()
        .filter(Thread::isAlive)
        .map(Thread::getName)
        .toList();
  }

  /** Describes the windows on the screen and the stacks of all threads. */
  static String desk() {
    StringBuilder desk = new StringBuilder();
    for (Window window : Window.getWindows()) {
      if (window.isShowing()) {
        String title = window instanceof Dialog dialog ? dialog.getTitle() : window.getName();
        desk.append(title).append(' ').append(ImagejProbeDialogs.texts(window)).append('\n');
      }
    }
    Thread.getAllStackTraces()
        .forEach(
            (thread, frames) -> {
              desk.append(thread).append(' ').append(thread.getState()).append('\n');
              for (StackTraceElement frame : frames) {
                desk.append("  ").append(frame).append('\n');
              }
            });
    return desk.toString();
  }

  static long usedAfterCollection() {
    long least = Long.MAX_VALUE;
    for (int n = 0; n < 5; n++) {
      System.gc();
      pause(100);
      Runtime runtime = Runtime.getRuntime();
      least = Math.min(least, runtime.totalMemory() - runtime.freeMemory());
    }
    return least;
  }
}
