package org.palpate.io.table;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.body.BodyGroups;
import org.palpate.testing.Seeds;

class GroupsCsvTest {
  private static final List<String> NAMES = List.of("skull", "a", "b,c", "d \"e\"", "f");

  /** Names that would begin a comment, break a line, or lose their blanks. */
  private static final List<String> HARD = List.of("skull", "#1", " b\t", "c\r\nd", "#");

  @TempDir private Path folder;

  private Path file() {
    return GroupsCsv.beside(folder.resolve("jaw.json"));
  }

  private void write(BodyGroups groups) throws IOException {
    try (OutputStream stream = Files.newOutputStream(file())) {
      GroupsCsv.write(stream, NAMES, groups);
    }
  }

  private Optional<BodyGroups> read() throws IOException {
    return GroupsCsv.read(file(), NAMES, body -> body > 0);
  }

  @Test
  void aTableLiesBesideItsScene() {
    assertEquals(folder.resolve("jaw.groups.csv"), file());
    assertEquals(Path.of("jaw.groups.csv"), GroupsCsv.beside(Path.of("jaw")));
  }

  @Test
  void anyLocksAndGroupsReadBackAsTheyWere() throws IOException {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    for (int trial = 0; trial < 200; trial++) {
      BodyGroups groups = BodyGroups.none(NAMES.size());
      for (int change = random.nextInt(6); change > 0; change--) {
        int one = 1 + random.nextInt(4);
        int other = 1 + random.nextInt(4);
        groups =
            switch (random.nextInt(3)) {
              case 0 -> groups.withLock(random.nextInt(5), random.nextBoolean());
              case 1 -> groups.bound(one, other);
              default -> groups.alone(one);
            };
      }
      write(groups);
      BodyGroups back = read().orElseThrow();
      for (int n = 0; n < NAMES.size(); n++) {
        assertEquals(groups.isLocked(n), back.isLocked(n), () -> "seed " + Seeds.seed());
        for (int m = 0; m < NAMES.size(); m++) {
          assertEquals(groups.moveTogether(n, m), back.moveTogether(n, m));
        }
      }
    }
  }

  @Test
  void bodiesWithHardNamesKeepTheirLocksAndGroups() throws IOException {
    BodyGroups groups = BodyGroups.none(HARD.size()).bound(1, 3).bound(2, 4).withLock(1, true);
    try (OutputStream stream = Files.newOutputStream(file())) {
      GroupsCsv.write(stream, HARD, groups);
    }
    BodyGroups back = GroupsCsv.read(file(), HARD, body -> body > 0).orElseThrow();
    assertTrue(back.moveTogether(1, 3));
    assertTrue(back.moveTogether(2, 4));
    assertTrue(back.isLocked(3));
    assertFalse(back.isLocked(2));
    assertFalse(back.isLocked(0));
  }

  @Test
  void aTableIsNeededForLocksAndGroupsAlone() throws IOException {
    BodyGroups none = BodyGroups.none(NAMES.size());
    assertFalse(GroupsCsv.isNeeded(NAMES.size(), none));
    assertTrue(GroupsCsv.isNeeded(NAMES.size(), none.withLock(4, true)));
    assertTrue(GroupsCsv.isNeeded(NAMES.size(), none.bound(2, 4)));
    assertEquals(Optional.empty(), read());
    write(none.bound(2, 4));
    assertEquals(
        "body,group,locked\nskull,1,0\na,2,0\n\"b,c\",3,0\n\"d \"\"e\"\"\",4,0\nf,3,0\n",
        Files.readString(file()));
  }

  @Test
  void aBodyWithoutARowMovesAlone() throws IOException {
    Files.writeString(file(), "locked,note,body,group\n1,x,a,left\n0,x,f,left\n");
    BodyGroups groups = read().orElseThrow();
    assertTrue(groups.moveTogether(1, 4));
    assertTrue(groups.isLocked(4), "the lock of one holds all that move with it");
    assertEquals(1, groups.size(2));
    assertFalse(groups.isLocked(0));
  }

  @Test
  void aWrongRowIsRefusedWithItsLine() throws IOException {
    assertRefused("a,1\n", "there is no column locked", "body,group");
    assertRefused("g,1,0\n", "there is no body g", "body,group,locked");
    assertRefused("a,1,0\na,2,0\n", "a has two rows", "body,group,locked");
    assertRefused("a,,0\n", "group is missing", "body,group,locked");
    assertRefused("a,1,2\n", "locked is 2", "body,group,locked");
    assertRefused("a,1\n", "locked is missing", "body,group,locked");
    assertRefused("a,1,0\nskull,1,0\n", "skull is attached", "body,group,locked");
  }

  private void assertRefused(String rows, String what, String header) throws IOException {
    Files.writeString(file(), header + "\n" + rows);
    String message = assertThrows(CsvFormatException.class, this::read).getMessage();
    assertTrue(message.startsWith(what), message);
    assertTrue(message.contains(file() + " line "), message);
  }
}
