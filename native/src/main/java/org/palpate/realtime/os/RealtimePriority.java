package org.palpate.realtime.os;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;

/**
 * The real-time priority of the haptic thread: below the threads of vendors' drivers, which must
 * run for a sample to arrive, and below the kernel's interrupt threads at 50.
 */
final class RealtimePriority {
  /** Where nothing asks for less. */
  static final int USUAL = 40;

  private static final int FIRST_FIELD_AFTER_NAME = 3;
  private static final int PRIORITY_FIELD = 40;

  private RealtimePriority() {}

  /**
   * One below the lowest real-time thread of this process, at most {@link #USUAL}, at least 1.
   *
   * @param tasks a folder of threads, as {@code /proc/self/task}
   */
  static int belowLowestThread(Path tasks) {
    int lowest = USUAL + 1;
    try (DirectoryStream<Path> threads = Files.newDirectoryStream(tasks)) {
      for (Path thread : threads) {
        int priority = priorityOf(KernelFiles.lines(thread.resolve("stat")));
        lowest = priority > 0 ? Math.min(lowest, priority) : lowest;
      }
    } catch (IOException e) {
      return USUAL; // no such folder: nothing is known of other threads
    }
    return Math.max(1, lowest - 1);
  }

  /** The real-time priority in a thread's {@code stat}; 0 where it has none. */
  static int priorityOf(Stream<String> stat) {
    String line = stat.findFirst().orElse("");
    // The name, in parentheses, may hold blanks and parentheses itself.
    String[] fields = line.substring(line.lastIndexOf(')') + 1).trim().split(" ", -1);
    int at = PRIORITY_FIELD - FIRST_FIELD_AFTER_NAME;
    return fields.length > at ? Integer.parseInt(fields[at]) : 0;
  }
}
