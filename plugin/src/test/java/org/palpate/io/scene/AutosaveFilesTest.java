package org.palpate.io.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AutosaveFilesTest {
  @TempDir private Path folder;

  private AutosaveFiles files;

  @BeforeEach
  void nameFiles() {
    files = AutosaveFiles.beside(folder.resolve("end.json"));
  }

  private void leave(String name) throws IOException {
    Files.writeString(folder.resolve(name), "left");
  }

  private String claimed() throws IOException {
    try (SavedScene scene = files.claim()) {
      return scene.file().getFileName().toString();
    }
  }

  private String last() {
    return files.last().map(file -> file.getFileName().toString()).orElse("");
  }

  @Test
  void whatACrashLeftIsFoundAndNotReplaced() throws IOException {
    leave("end.autosave.json.txt");
    leave("end.autosave1.json");
    leave("end.autosave02.json");
    assertEquals("", last(), "files of other programs");
    assertEquals("end.autosave.json", claimed());
    leave("end.autosave.json");
    assertEquals("end.autosave.json", last());
    assertEquals("end.autosave2.json", claimed());
    leave("end.autosave11.json");
    leave("end.autosave2.json");
    assertEquals("end.autosave11.json", last(), "the last has the highest number");
    assertEquals("end.autosave12.json", claimed());
    Files.delete(folder.resolve("end.autosave.json"));
    assertEquals("end.autosave12.json", claimed(), "a number is not used again below the last");
  }

  @Test
  void voxelsWithoutASceneAreNotReplacedEither() throws IOException {
    leave("end.autosave.nrrd");
    assertEquals("", last());
    assertEquals("end.autosave2.json", claimed());
  }

  @Test
  void sessionsAtOnceHaveNamesOfTheirOwnAndAreNotTakenForCrashed() throws IOException {
    try (SavedScene first = files.claim();
        SavedScene second = files.claim()) {
      assertEquals("end.autosave.json", first.file().getFileName().toString());
      assertEquals("end.autosave2.json", second.file().getFileName().toString());
      leave("end.autosave.json");
      leave("end.autosave2.json");
      assertEquals("", last());
      assertEquals("end.autosave3.json", claimed());
    }
    assertEquals("end.autosave2.json", last());
  }

  @Test
  void aSceneThatIsResumedBelongsToTheSameInput() throws IOException {
    leave("end.autosave.json");
    leave("end.autosave7.json");
    files = AutosaveFiles.beside(folder.resolve("end.autosave7.json"));
    assertEquals("end.autosave7.json", last());
    assertEquals("end.autosave8.json", claimed());
  }

  @Test
  void aNameInTheWorkingFolderHasNoFolder() {
    Path far = folder.resolve("far.json");
    assertEquals(Optional.empty(), AutosaveFiles.awayFrom(far).last());
    assertEquals(Optional.empty(), AutosaveFiles.inWorkingFolder("no such input").last());
    assertEquals(Optional.empty(), AutosaveFiles.beside(Path.of("no such scene.json")).last());
  }

  @Test
  void aFolderThatCannotBeWrittenToIsAnError() {
    files = AutosaveFiles.beside(folder.resolve("missing").resolve("end.json"));
    assertEquals("", last());
    assertThrows(IOException.class, files::claim);
  }

  @Test
  void theFirstPlaceThatCanBeWrittenToIsClaimed() throws IOException {
    AutosaveFiles missing = AutosaveFiles.beside(folder.resolve("missing").resolve("end.json"));
    AutosaveFiles gone = AutosaveFiles.beside(folder.resolve("gone").resolve("end.json"));
    try (SavedScene scene = AutosaveFiles.claimFirst(List.of(missing, files))) {
      assertEquals("end.autosave.json", scene.file().getFileName().toString());
    }
    IOException failure =
        assertThrows(
            IOException.class, () -> AutosaveFiles.claimFirst(List.of(missing, gone)).close());
    assertTrue(failure.getMessage().contains("gone"), failure::toString);
    assertTrue(failure.getSuppressed()[0].getMessage().contains("missing"), failure::toString);
  }
}
