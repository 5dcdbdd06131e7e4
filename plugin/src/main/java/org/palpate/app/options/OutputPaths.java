package org.palpate.app.options;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.palpate.app.process.PalpateException;

/** Looks at where output goes before any work is done. */
public final class OutputPaths {
  private OutputPaths() {}

  /**
   * The target, once it is known that it can be written.
   *
   * @param option that named it
   * @param inputs files that must not be written
   * @throws PalpateException exit code 2
   */
  public static Path checked(String option, Path target, List<Path> inputs) {
    Path folder = target.toAbsolutePath().getParent();
    if (Files.isDirectory(target)) {
      throw wrong("it is a folder", option, target, "name a file in it");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw wrong("there is no such folder", option, target, "make the folder first");
    }
    boolean isThere = Files.exists(target);
    if (isThere ? !Files.isWritable(target) : !Files.isWritable(folder)) {
      throw wrong("it may not be written", option, target, "choose another place");
    }
    for (Path input : inputs) {
      if (isThere && isSame(target, input)) {
        throw wrong("it is an input", option, target, "name another file");
      }
    }
    return target;
  }

  /**
   * The folder, which may be made later, once it is known that no file stands in its place.
   *
   * @throws PalpateException exit code 2
   */
  static Path checkedFolder(String option, Path folder) {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw wrong("not a folder", option, folder, "name a new folder");
    }
    return folder;
  }

  /**
   * Refuses two outputs in one file.
   *
   * @throws PalpateException exit code 2
   */
  public static void checkDistinct(List<Path> targets) {
    Set<Path> seen = new HashSet<>();
    for (Path target : targets) {
      if (!seen.add(target.toAbsolutePath().normalize())) {
        throw PalpateException.wrongUse(
            "two outputs have one file", target.toString(), "name a file for each");
      }
    }
  }

  private static boolean isSame(Path a, Path b) {
    try {
      return Files.isSameFile(a, b);
    } catch (IOException e) {
      return false; // one of them is not there
    }
  }

  private static PalpateException wrong(String what, String option, Path target, String remedy) {
    return PalpateException.wrongUse(what, option + " " + target, remedy);
  }

  /** What to tell where a target that looked well could not be written. */
  public static PalpateException failed(Path target, IOException cause) {
    return failed(target.toString(), cause);
  }

  /** As above, of a target by its name. */
  public static PalpateException failed(String target, IOException cause) {
    return PalpateException.failed(
        "could not be written (" + cause.getMessage() + ")",
        target,
        "look at the disk and its permissions",
        cause);
  }
}
