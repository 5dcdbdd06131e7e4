package org.palpate.io.file;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FileClaimTest {
  @TempDir private Path folder;

  private Path lockFile() {
    return folder.resolve(".a.json.lock");
  }

  @Test
  void oneHolderAtATimeHasAFile() throws IOException {
    Path file = folder.resolve("a.json");
    assertFalse(FileClaim.isHeld(file));
    try (FileClaim claim = FileClaim.of(file).orElseThrow()) {
      assertNotNull(claim);
      assertTrue(FileClaim.isHeld(file));
      assertEquals(Optional.empty(), FileClaim.of(folder.resolve("b").resolve("..").resolve(file)));
      assertTrue(FileClaim.isHeld(file), "a failed claim does not end that of the holder");
      FileClaim.of(folder.resolve("b.json")).orElseThrow().close();
      assertTrue(Files.exists(lockFile()));
    }
    assertFalse(FileClaim.isHeld(file));
    assertFalse(Files.exists(lockFile()));
    FileClaim.of(file).orElseThrow().close();
  }

  @Test
  void aHolderHasTheFileUnderEachNameOfItsFolder() throws IOException {
    Path real = Files.createDirectories(folder.resolve("deep").resolve("real"));
    Path link = Files.createSymbolicLink(folder.resolve("link"), real);
    try (FileClaim claim = FileClaim.of(real.resolve("a.json")).orElseThrow()) {
      assertNotNull(claim);
      assertTrue(FileClaim.isHeld(link.resolve("a.json")));
      assertEquals(Optional.empty(), FileClaim.of(link.resolve("a.json")));
      Path up = link.resolve("..").resolve("real").resolve("a.json");
      assertEquals(Optional.empty(), FileClaim.of(up));
    }
  }

  @Test
  void whatAProcessLeftThatWasKilledIsClaimedAgain() throws IOException {
    Path file = folder.resolve("a.json");
    Files.createFile(lockFile());
    assertFalse(FileClaim.isHeld(file));
    assertTrue(Files.exists(lockFile()));
    FileClaim.of(file).orElseThrow().close();
    assertFalse(Files.exists(lockFile()));
  }

  @Test
  void theEndOfTheProcessDeletesALockFile() throws IOException {
    FileClaim claim = FileClaim.of(folder.resolve("a.json")).orElseThrow();
    AtomicFile.discardUnfinished();
    assertFalse(Files.exists(lockFile()));
    claim.close();
  }

  @Test
  void aFolderThatCannotBeWrittenToIsAnError() {
    Path file = folder.resolve("missing").resolve("a.json");
    IOException said = assertThrows(IOException.class, () -> FileClaim.of(file));
    assertEquals(file + ": NoSuchFile", said.getMessage());
    assertThrows(IOException.class, () -> FileClaim.of(file), "not held by the first try");
    assertFalse(FileClaim.isHeld(file));
  }
}
