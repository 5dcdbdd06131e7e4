package org.palpate.io.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class AtomicFileTest {
  @TempDir private Path folder;

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private List<String> names() throws IOException {
    try (Stream<Path> files = Files.list(folder)) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void theTargetAppearsOnlyWhenItIsWhole() throws IOException {
    Path target = folder.resolve("t.csv");
    try (AtomicFile file = new AtomicFile(target)) {
      file.stream().write(bytes("one "));
      assertFalse(Files.exists(target));
      file.stream().write(bytes("two"));
      file.commit();
      assertEquals("one two", Files.readString(target));
    }
    assertEquals(List.of("t.csv"), names());
    assertEquals("one two", Files.readString(target), "closing after a commit changes nothing");
  }

  @Test
  void anOldFileStaysUntilTheNewOneIsWhole() throws IOException {
    Path target = Files.writeString(folder.resolve("t.csv"), "old");
    try (AtomicFile file = new AtomicFile(target)) {
      file.stream().write(bytes("new"));
      file.stream().flush();
      assertEquals("old", Files.readString(target));
      assertEquals(2, names().size(), "the temporary file lies beside it");
    }
    assertEquals("old", Files.readString(target), "closed without a commit");
    assertEquals(List.of("t.csv"), names());
    AtomicFile.write(target, "new \u00e9");
    assertEquals("new \u00e9", Files.readString(target));
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: links of another kind")
  void aLinkStaysAndWhatItPointsToIsReplaced() throws IOException {
    Path real = Files.writeString(folder.resolve("real.csv"), "old");
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), real);
    AtomicFile.write(link, "new");
    assertTrue(Files.isSymbolicLink(link));
    assertEquals("new", Files.readString(real));
  }

  @Test
  void aFailureNamesTheTargetAndNotTheTemporaryFile() {
    Path target = folder.resolve("none").resolve("t.csv");
    WriteFailedException failure =
        assertThrows(WriteFailedException.class, () -> new AtomicFile(target));
    assertEquals(target.toString(), failure.target());
    assertEquals("NoSuchFile", failure.getMessage());
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: no /dev/full on this system")
  void aFullDiskIsReportedWhileItIsWritten() throws IOException {
    Path full = Path.of("/dev/full");
    AtomicFile file = new AtomicFile(full);
    WriteFailedException failure =
        assertThrows(WriteFailedException.class, () -> file.stream().write(new byte[1 << 17]));
    assertEquals("/dev/full", failure.target());
    assertEquals("No space left on device", failure.getMessage());
    file.close();
    AtomicFile single = new AtomicFile(full);
    single.stream().write(1);
    assertThrows(WriteFailedException.class, single::commit);
    assertTrue(Files.exists(full), "a device is never replaced");
  }

  @Test
  void theEndOfTheProcessLeavesNoUnfinishedFile() throws IOException {
    Path whole = folder.resolve("whole.csv");
    AtomicFile.write(whole, "whole");
    AtomicFile open = new AtomicFile(folder.resolve("open.csv"));
    open.stream().write(bytes("begun"));
    AtomicFile.discardUnfinished();
    assertEquals(List.of("whole.csv"), names());
    open.close();
    assertEquals("whole", Files.readString(whole));
  }
}
