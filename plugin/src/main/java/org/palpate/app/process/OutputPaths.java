package org.palpate.app.process;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.palpate.volume.Segment;

/** Checks the targets of output before any work is done. */
public final class OutputPaths {
  private OutputPaths() {}

  /**
   * Returns the target after checking that it can be written.
   *
   * @param option the option that named it
   * @param inputs files that must not be replaced
   * @throws PalpateException exit code 2, if it cannot be written
   */
  public static Path checked(String option, Path target, List<Path> inputs) {
    Path folder = target.toAbsolutePath().getParent();
    if (Files.isDirectory(target)) {
      throw wrong("the target is a folder", option, target, "name a file in it");
    }
    if (folder == null || !Files.isDirectory(folder)) {
      throw wrong("there is no such folder", option, target, "create the folder first");
    }
    boolean exists = Files.exists(target);
    if (exists ? !Files.isWritable(target) : !Files.isWritable(folder)) {
      throw wrong("there is no permission to write", option, target, "choose another place");
    }
    for (Path input : inputs) {
      if (exists && isSame(target, input)) {
        throw wrong("the target is an input", option, target, "name another file");
      }
    }
    return target;
  }

  /**
   * Returns a folder, which need not exist yet, after checking that no file has its name.
   *
   * @throws PalpateException exit code 2, if a file has that name
   */
  public static Path checkedFolder(String option, Path folder) {
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw wrong("the target is not a folder", option, folder, "name a new folder");
    }
    return folder;
  }

  /**
   * Returns a part of a file's name for each segment: letters, digits, dots, hyphens, underscores.
   * If several have the same one, whatever the case of its letters, a number makes them different.
   */
  public static List<String> fileWords(List<Segment> segments) {
    Set<String> used = new HashSet<>();
    List<String> words = new ArrayList<>();
    for (Segment segment : segments) {
      String word = segment.name().strip().replaceAll("[^\\p{L}\\p{N}._-]+", "_");
      String unique = word;
      for (int n = 2; !used.add(unique.toLowerCase(Locale.ROOT)); n++) {
        unique = word + "-" + n;
      }
      words.add(unique);
    }
    return words;
  }

  /**
   * Checks that no two outputs have the same file.
   *
   * @throws PalpateException exit code 2, if two have
   */
  public static void checkDistinct(List<Path> targets) {
    Set<Path> seen = new HashSet<>();
    for (Path target : targets) {
      if (!seen.add(target.toAbsolutePath().normalize())) {
        throw PalpateException.wrongUse(
            "two outputs have the same file", target.toString(), "name a file for each");
      }
    }
  }

  private static boolean isSame(Path a, Path b) {
    try {
      return Files.isSameFile(a, b);
    } catch (IOException e) {
      return false; // one of them does not exist
    }
  }

  private static PalpateException wrong(String what, String option, Path target, String remedy) {
    return PalpateException.wrongUse(what, option + " " + target, remedy);
  }

  /** Returns the line that says that a file or a folder was written. */
  public static String written(Path target, String content) {
    return "written: " + target + ": " + content;
  }

  /** Returns the error for a target that passed the check but could not be written. */
  public static PalpateException failed(Path target, IOException cause) {
    return failed(target.toString(), cause);
  }

  /** Returns the error for a target, given by its name, that could not be written. */
  public static PalpateException failed(String target, IOException cause) {
    return PalpateException.failed(
        "could not be written (" + cause.getMessage() + ")",
        target,
        "check the disk and its permissions",
        cause);
  }
}
