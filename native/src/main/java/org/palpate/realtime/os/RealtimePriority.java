package org.palpate.realtime.os;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * Chooses the real-time priority of the haptic thread. It lies below the threads of vendors'
 * drivers, which must run for a sample to arrive, and below the kernel's interrupt threads at 50.
 */
final class RealtimePriority {
  /** The priority if no other thread requires a lower one. */
  static final int DEFAULT = 40;

  private static final int FIRST_FIELD_AFTER_NAME = 3;
  private static final int PRIORITY_FIELD = 40;

  private RealtimePriority() {}

  /**
   * Returns one less than the lowest real-time priority in this process, within 1 and {@link
   * #DEFAULT}.
   *
   * @param tasks a folder of threads such as {@code /proc/self/task}
   */
  static int belowLowestThread(Path tasks) {
    int lowest = DEFAULT + 1;
    try (DirectoryStream<Path> threads = Files.newDirectoryStream(tasks)) {
      for (Path thread : threads) {
        int priority = priorityOf(KernelFiles.lines(thread.resolve("stat")));
        lowest = priority > 0 ? Math.min(lowest, priority) : lowest;
      }
    } catch (IOException e) {
      return DEFAULT; // without this folder nothing is known of other threads
    }
    return Math.max(1, lowest - 1);
  }

  /** Returns the real-time priority in a thread's {@code stat}; 0 if it has none. */
  static int priorityOf(Stream<String> stat) {
    String line = stat.findFirst().orElse("");
    // The name, in parentheses, may itself contain spaces and parentheses.
    String[] fields = line.substring(line.lastIndexOf(')') + 1).trim().split(" ", -1);
    int at = PRIORITY_FIELD - FIRST_FIELD_AFTER_NAME;
    return fields.length > at ? Integer.parseInt(fields[at]) : 0;
  }
}
