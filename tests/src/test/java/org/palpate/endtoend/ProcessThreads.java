package org.palpate.endtoend;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;

/** The threads of another process, as Linux lists them. */
final class ProcessThreads {
  private ProcessThreads() {}

  /** Whether a process has a thread whose name begins so; Linux keeps 15 characters of a name. */
  static boolean has(long process, String name) throws IOException {
    try (DirectoryStream<Path> threads =
        Files.newDirectoryStream(Path.of("/proc/" + process + "/task"))) {
      for (Path thread : threads) {
        if (name(thread).startsWith(name)) {
          return true;
        }
      }
    }
    return false;
  }

  private static String name(Path thread) throws IOException {
    try {
      return Files.readString(thread.resolve("comm"));
    } catch (IOException e) {
      if (Files.exists(thread)) {
        throw e;
      }
      return ""; // The thread has ended, maybe after the file was opened: then the read fails.
    }
  }
}
