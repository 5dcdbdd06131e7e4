package org.palpate.io.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.io.volume.VolumeFormatException;

class InputFilesTest {
  @TempDir private Path folder;

  private static String refusal(org.junit.jupiter.api.function.Executable call) {
    return assertThrows(VolumeFormatException.class, call).getMessage();
  }

  @Test
  void aFileIsReadFromAnOffset() throws IOException {
    Path file = Files.write(folder.resolve("a"), new byte[] {1, 2, 3});
    try (InputStream in = InputFiles.open(file, 2)) {
      assertEquals(3, in.read());
      assertEquals(-1, in.read());
    }
    assertThrows(IOException.class, () -> InputFiles.open(file, 4));
    assertEquals(2, InputFiles.firstBytes(file, 2).length);
    assertEquals(3, InputFiles.firstBytes(file, 99).length);
    assertEquals(3, InputFiles.length(file));
  }

  @Test
  void whatCannotBeReadIsSaidWithItsName() {
    Path none = folder.resolve("none");
    assertEquals(
        "no such file: " + none + ": check the path", refusal(() -> InputFiles.length(none)));
    assertEquals(
        "not a regular file: " + folder + ": name a file",
        refusal(() -> InputFiles.length(folder)));
    assertEquals(
        "no such file: " + none + ": check that it exists and that you may read it",
        refusal(() -> InputFiles.firstBytes(none, 1)));
    assertTrue(refusal(() -> InputFiles.entries(none)).startsWith("no such file: " + none));
  }

  @Test
  void theEntriesOfAFolderAreSorted() throws IOException {
    for (String name : List.of("b", "a", "C", "10", "9")) {
      Files.createFile(folder.resolve(name));
    }
    assertEquals(
        List.of("10", "9", "C", "a", "b"),
        InputFiles.entries(folder).stream().map(file -> file.getFileName().toString()).toList());
  }

  @Test
  void aHeaderNamesFilesInItsFolderOrBelow() throws IOException {
    Path header = folder.resolve("h.nhdr");
    Path below = Files.createDirectory(folder.resolve("sub"));
    Files.createFile(folder.resolve("a.raw"));
    Files.createFile(below.resolve("b.raw"));
    assertEquals(folder.resolve("a.raw").toRealPath(), InputFiles.resolveBeside(header, "a.raw"));
    assertEquals(
        below.resolve("b.raw").toRealPath(), InputFiles.resolveBeside(header, "sub/b.raw"));
    assertEquals(
        folder.resolve("a.raw").toRealPath(), InputFiles.resolveBeside(header, "sub/../a.raw"));
    assertEquals(
        "the data file 'c.raw' is missing: " + header + ": put it into the folder of the header",
        refusal(() -> InputFiles.resolveBeside(header, "c.raw")));
    assertEquals(
        "the data file 'a\0b' is no valid file name: " + header + ": correct the name",
        refusal(() -> InputFiles.resolveBeside(header, "a\0b")).replace("a?b", "a\0b"));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"../h.raw", "/etc/passwd", "sub/../../h.raw", "..\\h.raw", "C:\\h.raw", "", " "})
  void aHeaderNamesNothingOutside(String name) throws IOException {
    Path inner = Files.createDirectory(folder.resolve("inner"));
    Files.createFile(folder.resolve("h.raw"));
    Path header = inner.resolve("h.nhdr");
    assertEquals(
        "the data file '"
            + name
            + "' is outside its folder: "
            + header
            + ": put the data file into the folder of the header and name it without a path",
        refusal(() -> InputFiles.resolveBeside(header, name)));
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: links of another kind")
  void aLinkDoesNotLeadOutside() throws IOException {
    Path inner = Files.createDirectory(folder.resolve("inner"));
    Path outside = Files.createFile(folder.resolve("h.raw"));
    Files.createSymbolicLink(inner.resolve("link.raw"), outside);
    assertTrue(
        refusal(() -> InputFiles.resolveBeside(inner.resolve("h.nhdr"), "link.raw"))
            .startsWith("the data file 'link.raw' is outside its folder: "));
  }

  @Test
  void endingsAreFoundInUpperAndLowerCase() {
    assertTrue(InputFiles.hasEnding(Path.of("a/B.NII.gz"), ".tif", ".nii.gz"));
    assertFalse(InputFiles.hasEnding(Path.of("a.nii/b"), ".nii"));
  }

  @Test
  void slicesAreSortedByTheLastNumberOfTheirNames() throws IOException {
    for (String name : List.of("s10.raw", "s9.raw", "3-s009.raw", "note", "s1e400")) {
      Files.createFile(folder.resolve(name));
    }
    Files.createDirectory(folder.resolve("s5"));
    assertEquals(
        List.of("3-s009.raw", "s9.raw", "s10.raw", "s1e400"),
        SliceFiles.of(folder).stream().map(file -> file.getFileName().toString()).toList());
    Path empty = Files.createDirectory(folder.resolve("empty"));
    assertEquals(
        "the folder has no numbered files: "
            + empty
            + ": number the slices, as in slice.1, slice.2",
        refusal(() -> SliceFiles.of(empty)));
  }

  @Test
  void memoryThatIsNotThereIsRefusedBeforeItIsTaken() throws VolumeFormatException {
    MemoryCheck.require(1, "a byte", "x");
    String said = refusal(() -> MemoryCheck.require(1e15, "keeping its grey values", "scan.nrrd"));
    assertTrue(
        said.startsWith("keeping its grey values needs 1000 TB of memory with a reserve, but ")
            || said.startsWith(
                "keeping its grey values needs 1.0 PB of memory with a reserve, but "),
        said);
    assertTrue(said.contains(" are free: scan.nrrd: give Java more memory"), said);
  }
}
