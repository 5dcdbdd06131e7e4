package org.palpate.io.table;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.palpate.body.BodyGroups;

/**
 * Reads and writes the locks and the groups of the bodies of a scene: {@code body,group,locked} in
 * any order. Bodies with the same number in {@code group} move as one. A body without a row moves
 * alone and is not locked. Further columns are allowed. One thread.
 */
public final class GroupsCsv implements CsvLines.Rows {
  private static final List<String> COLUMNS = List.of("body", "group", "locked");
  private static final String HEADER = String.join(",", COLUMNS);
  private static final String SCENE_ENDING = ".json";

  private final CsvLines lines;
  private final List<String> bodies;
  private final IntPredicate canMove;
  private final Map<String, Integer> firstOfGroup = new HashMap<>();
  private final Set<Integer> locked = new TreeSet<>();
  private final Set<Integer> named = new TreeSet<>();
  private BodyGroups groups;
  private int[] columns = {};

  private GroupsCsv(Path file, List<String> bodies, IntPredicate canMove) {
    lines = new CsvLines(file);
    this.bodies = bodies.stream().map(GroupsCsv::inOneLine).toList();
    this.canMove = canMove;
    groups = BodyGroups.none(bodies.size());
  }

  /** Returns the table that belongs to a scene file: {@code NAME.groups.csv}. */
  public static Path beside(Path scene) {
    return scene.resolveSibling(stem(scene) + ".groups.csv");
  }

  /** Returns the name of a scene file without its folder and its ending, if it has that ending. */
  public static String stem(Path scene) {
    String name = scene.getFileName().toString();
    boolean hasEnding = name.endsWith(SCENE_ENDING);
    return hasEnding ? name.substring(0, name.length() - SCENE_ENDING.length()) : name;
  }

  /** Whether a body is locked or does not move alone, by the number of all bodies. */
  public static boolean isNeeded(int bodies, BodyGroups groups) {
    return IntStream.range(0, bodies).anyMatch(n -> groups.size(n) > 1 || groups.isLocked(n));
  }

  /**
   * Writes a row for each body, and leaves the stream open.
   *
   * @param bodies the names of all bodies in the order of the scene
   * @throws IOException if that is not possible
   */
  public static void write(OutputStream stream, List<String> bodies, BodyGroups groups)
      throws IOException {
    CsvWriter rows = new CsvWriter(stream, HEADER);
    for (int n = 0; n < bodies.size(); n++) {
      int first = 0;
      while (!groups.moveTogether(first, n)) {
        first++;
      }
      rows.cell(inOneLine(bodies.get(n))).cell(first + 1L).cell(groups.isLocked(n) ? 1L : 0L).end();
    }
  }

  /** Returns a name as a row can hold it: in one line, without blanks around it. */
  private static String inOneLine(String name) {
    return name.strip().replaceAll("\\R+", " ");
  }

  /**
   * Reads a file.
   *
   * @param bodies the names of all bodies in the order of the scene
   * @param canMove whether a body can move, by its number
   * @return empty if there is no such file
   * @throws CsvFormatException if the file is not understood, names a body that does not exist, or
   *     attaches one that cannot move; the message names the line
   */
  public static Optional<BodyGroups> read(Path file, List<String> bodies, IntPredicate canMove)
      throws IOException {
    if (!Files.exists(file)) {
      return Optional.empty();
    }
    GroupsCsv reader = new GroupsCsv(file, bodies, canMove);
    reader.lines.read(HEADER, reader);
    for (int body : reader.locked) {
      reader.groups = reader.groups.withLock(body, true);
    }
    return Optional.of(reader.groups);
  }

  @Override
  public void header(List<String> names) throws CsvFormatException {
    columns = lines.neededColumns(names, COLUMNS);
  }

  @Override
  public void row(String[] words) throws CsvFormatException {
    String name = CsvLines.word(words, columns[0]);
    int body = bodies.indexOf(name);
    if (body < 0 || !named.add(body)) {
      throw lines.fault(
          body < 0 ? "there is no body " + name : name + " has two rows",
          "name each body of the scene once");
    }
    String group = CsvLines.word(words, columns[1]);
    if (group.isEmpty()) {
      throw lines.fault("group is missing", "give bodies that move as one the same number");
    }
    Integer first = firstOfGroup.putIfAbsent(group, body);
    if (first != null) {
      requireMovable(first);
      requireMovable(body);
      groups = groups.bound(first, body);
    }
    String lock = CsvLines.word(words, columns[2]);
    if (!lock.equals("0") && !lock.equals("1")) {
      throw lines.fault("locked is " + (lock.isEmpty() ? "missing" : lock), "write 0 or 1");
    }
    if (lock.equals("1")) {
      locked.add(body);
    }
  }

  private void requireMovable(int body) throws CsvFormatException {
    if (!canMove.test(body)) {
      throw lines.fault(
          bodies.get(body) + " is attached, and it cannot move", "give it a number of its own");
    }
  }
}
