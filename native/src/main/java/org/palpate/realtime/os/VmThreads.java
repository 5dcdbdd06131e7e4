package org.palpate.realtime.os;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds the JVM's own threads that a safepoint waits for: the VM thread and the workers of a
 * stopping collector. A stopped haptic thread waits for them too, so ordinary threads must not
 * delay them on a busy machine (priority inversion).
 */
final class VmThreads {
  private VmThreads() {}

  /**
   * Returns the numbers of these threads.
   *
   * @param tasks a folder of threads such as {@code /proc/self/task}
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
      return List.of(); // without this folder nothing is known of other threads
    }
    return found;
  }
}
