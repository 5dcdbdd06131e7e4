package org.palpate.app.options;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;

class OutputPathsTest {
  @TempDir private Path folder;

  @Test
  void aNewFileInAFolderThatIsThereMayBeWritten() {
    Path target = folder.resolve("new.csv");
    assertSame(target, OutputPaths.checked("--out", target, List.of(folder.resolve("in.csv"))));
  }

  @Test
  void aFileThatIsNoInputMayBeReplaced() throws IOException {
    Path old = Files.writeString(folder.resolve("old.csv"), "old");
    Path input = Files.writeString(folder.resolve("in.csv"), "in");
    assertSame(old, OutputPaths.checked("--out", old, List.of(input)));
    assertEquals("old", Files.readString(old), "a check writes nothing");
  }

  @Test
  void eachTargetThatCannotBeWrittenIsRefused() {
    Path inside = folder.resolve("none").resolve("x.csv");
    Given.refuses(
        "there is no such folder: --out " + inside + ": create the folder first",
        () -> OutputPaths.checked("--out", inside, List.of()));
    Given.refuses(
        "the target is a folder: --legs " + folder + ": name a file in it",
        () -> OutputPaths.checked("--legs", folder, List.of()));
  }

  @Test
  @EnabledOnOs(value = OS.LINUX, disabledReason = "skipped: links of another kind")
  void anInputIsFoundUnderEveryName() throws IOException {
    Path input = Files.writeString(folder.resolve("in.csv"), "in");
    Path link = Files.createSymbolicLink(folder.resolve("link.csv"), input);
    Path around = folder.resolve(".").resolve("in.csv");
    for (Path target : List.of(input, link, around)) {
      Given.refuses(
          "the target is an input: --out " + target + ": name another file",
          () -> OutputPaths.checked("--out", target, List.of(folder.resolve("missing"), input)));
    }
  }

  @Test
  void aFolderOfOutputNeedNotExist() throws IOException {
    Path wanted = folder.resolve("a").resolve("b");
    assertSame(wanted, OutputPaths.checkedFolder("--out", wanted));
    assertSame(folder, new OutputOptions().checked(folder));
    Path file = Files.writeString(folder.resolve("f"), "");
    Given.refuses(
        "the target is not a folder: --out " + file + ": name a new folder",
        () -> new OutputOptions().checked(file));
  }

  @Test
  void twoOutputsNeverShareAFile() {
    OutputPaths.checkDistinct(List.of(folder.resolve("a"), folder.resolve("b")));
    Path again = folder.resolve("x").resolve("..").resolve("a");
    Given.refuses(
        "two outputs have the same file: " + again + ": name a file for each",
        () -> OutputPaths.checkDistinct(List.of(folder.resolve("a"), again)));
  }

  @Test
  void aNameOfASegmentBecomesAPartOfAFilesName() {
    assertEquals(
        List.of("left_jaw", "left_jaw-2", "Left_Jaw-3", "Zähne.1_a-b", "_"),
        words("left jaw", "left/jaw", " Left  Jaw ", "Zähne.1_a-b", "?*"));
  }

  private static List<String> words(String... names) {
    BitCube none = new BitCube(4, 4, 4);
    return OutputPaths.fileWords(Stream.of(names).map(name -> new Segment(name, none, 0)).toList());
  }

  @Test
  void aNumberThatMakesANameUniqueIsNotTakenTwice() {
    assertEquals(List.of("a", "a-2", "a-3"), words("a", "a-2", "a"));
  }

  @Test
  void aFailureNamesItsCauseAndIsNoWrongUse() {
    PalpateException failure = OutputPaths.failed(Path.of("r.json"), new IOException("disk full"));
    assertEquals(
        "could not be written (disk full): r.json: check the disk and its permissions",
        failure.getMessage());
    assertEquals(PalpateException.FAILED, failure.exitCode());
    assertEquals("disk full", failure.getCause().getMessage());
  }

  @Test
  void aReportIsWrittenOnlyIfItWasAskedFor() {
    assertEquals(Optional.empty(), Given.options(new OutputOptions()).report());
    assertEquals(
        Optional.of(Path.of("r.json")),
        Given.options(new OutputOptions(), "--report=r.json", "--debug").report());
  }
}
