package org.palpate.realtime.os;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The JVM's own threads that a safepoint waits for: the one that runs its operation and the workers
 * of a stopping collector. A haptic thread that is stopped waits for them, so on a busy machine
 * they must not wait for everyone else (priority inversion).
 */
final class VmThreads {
  private VmThreads() {}

  /**
   * Their thread numbers.
   *
   * @param tasks a folder of threads, as {@code /proc/self/task}
   */
  static List<Integer> in(Path tasks) {
    List<Integer> found = new ArrayList<>();
    try (DirectoryStream<Path> threads = Files.newDirectoryStream(tasks)) {
      for (Path thread : threads) {
        String name = KernelFiles.line(thread.resolve("comm")).orElse("");
        if (name.equals("VM Thread") || name.startsWith("GC Thread#")) {
          found.add(Integer.parseInt(thread.getFileName().toString()));
        }
      }
    } catch (IOException e) {
      return List.of(); // no such folder: nothing is known of other threads
    }
    return found;
  }
}
