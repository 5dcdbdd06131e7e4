package org.palpate.io.scene;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.palpate.io.file.FileClaim;
import org.palpate.io.table.GroupsCsv;

/**
 * The names under which sessions of one input are saved while they run: {@code NAME.autosave.json},
 * {@code NAME.autosave2.json} and so on. What a session leaves there is not replaced: the next one
 * gets a higher number.
 */
public final class AutosaveFiles {
  private static final String SCENE = ".json";
  private static final String VOLUME = ".nrrd";

  private static final String MARK = ".autosave";
  private static final Pattern NUMBERED = Pattern.compile("\\.autosave\\d*$");

  private final Path folder;
  private final String stem;

  private AutosaveFiles(Path folder, String stem) {
    this.folder = folder;
    this.stem = stem + MARK;
  }

  /** Returns the names beside a scene file; those of the same input if it is such a file itself. */
  public static AutosaveFiles beside(Path scene) {
    Path folder = scene.getParent();
    return new AutosaveFiles(folder == null ? Path.of("") : folder, word(scene));
  }

  /** Returns the names in the working folder for a scene file that lies elsewhere. */
  public static AutosaveFiles awayFrom(Path scene) {
    return inWorkingFolder(word(scene));
  }

  /**
   * Returns the names in the working folder for an input that is no file.
   *
   * @param word the name of the input, fit for a file
   */
  public static AutosaveFiles inWorkingFolder(String word) {
    return new AutosaveFiles(Path.of(""), word);
  }

  /** Returns the name of a scene file without its ending and without the mark of these files. */
  private static String word(Path scene) {
    return NUMBERED.matcher(GroupsCsv.stem(scene)).replaceFirst("");
  }

  private Path file(int number, String ending) {
    return folder.resolve(stem + (number == 1 ? "" : number) + ending);
  }

  /** Returns the files that exist, by their numbers. */
  private SortedMap<Integer, Path> existing(String endings) {
    Pattern name = Pattern.compile(Pattern.quote(stem) + "([2-9]|[1-9]\\d{1,8}|)" + endings);
    SortedMap<Integer, Path> existing = new TreeMap<>();
    String[] names = folder.toAbsolutePath().toFile().list();
    for (String each : names == null ? new String[0] : names) {
      Matcher matcher = name.matcher(each);
      if (matcher.matches()) {
        String number = matcher.group(1);
        existing.put(number.isEmpty() ? 1 : Integer.parseInt(number), folder.resolve(each));
      }
    }
    return existing;
  }

  /** Returns the last scene that a session has left which does not run any more, if any. */
  public Optional<Path> last() {
    Optional<Path> last = Optional.empty();
    for (Path scene : existing("\\.json").values()) {
      if (!FileClaim.isHeld(scene)) {
        last = Optional.of(scene);
      }
    }
    return last;
  }

  /**
   * Claims the next name in the first place where that is possible.
   *
   * @param places the places, at least one, the preferred one first
   * @throws IOException if it is possible in none; the failure of the last one
   */
  public static SavedScene claimFirst(List<AutosaveFiles> places) throws IOException {
    IOException failure = null;
    for (AutosaveFiles place : places) {
      try {
        return place.claim();
      } catch (IOException e) {
        if (failure != null) {
          e.addSuppressed(failure);
        }
        failure = e; // the next place may do
      }
    }
    throw Objects.requireNonNull(failure, "there is no place");
  }

  /**
   * Claims the next name that no session has used.
   *
   * @throws IOException if the folder cannot be written to, or does not support locks
   */
  public SavedScene claim() throws IOException {
    SortedMap<Integer, Path> used = existing("\\.(json|nrrd|groups\\.csv)");
    int number = used.isEmpty() ? 1 : used.lastKey() + 1;
    Optional<SavedScene> claimed = claim(number);
    while (claimed.isEmpty()) {
      number++;
      claimed = claim(number);
    }
    return claimed.get();
  }

  /** Claims a name; returns empty if another session has it, or left a file under it just now. */
  private Optional<SavedScene> claim(int number) throws IOException {
    Path scene = file(number, SCENE);
    Path volume = file(number, VOLUME);
    Optional<FileClaim> claim = FileClaim.of(scene);
    if (claim.isPresent() && (Files.exists(scene) || Files.exists(volume))) {
      claim.get().close();
      return Optional.empty();
    }
    return claim.map(held -> new SavedScene(scene, volume, held));
  }
}
