package org.palpate.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Follows the README as a newcomer does: its commands and its program, in an empty folder. */
class ReadmeTest {
  @TempDir private Path folder;
  private Page readme;

  @BeforeEach
  void readReadme() throws IOException {
    readme = Page.read(Sources.root().resolve("README.md"));
  }

  @Test
  void commandsLeaveWhatTheyPromise() throws Exception {
    runCommands();
    for (String name : List.of("head.nii.gz", "t.csv", "legs.csv")) {
      assertTrue(Files.size(folder.resolve(name)) > 0, name);
    }
  }

  @Test
  void programRunsAndReachesTheForceThatTheTextNames() throws Exception {
    run(main(), CommandLines.of(block("info --phantom")).get(0));
    Files.writeString(folder.resolve("TouchOffline.java"), java());
    List<String> words = CommandLines.words(block("TouchOffline.java").strip());
    int file = words.indexOf("TouchOffline.java");

    String out = run(List.of(), words.subList(file, words.size()));

    String newton = out.strip().replaceAll("(?s).* ([0-9.]+) N$", "$1");
    String rounded = String.format(java.util.Locale.ROOT, "%.1f N", Double.parseDouble(newton));
    String text = String.join(" ", readme.prose());
    assertTrue(text.contains("the force grows to " + rounded), rounded);
  }

  /** Runs the block of commands that need neither a window nor ten seconds. */
  private void runCommands() throws Exception {
    for (List<String> command : CommandLines.of(block("--record t.csv"))) {
      List<String> arguments = new ArrayList<>(command);
      if (command.get(0).equals("touch")) {
        arguments.set(arguments.indexOf("--seconds") + 1, "1");
        arguments.add("--headless");
      }
      run(main(), arguments);
    }
  }

  private String block(String part) {
    return readme.blocks().stream()
        .filter(block -> block.language().isEmpty() && block.text().contains(part))
        .findFirst()
        .orElseThrow()
        .text();
  }

  private String java() {
    return readme.blocks().stream()
        .filter(block -> block.language().equals("java"))
        .findFirst()
        .orElseThrow()
        .text();
  }

  private static List<String> main() {
    return List.of("org.palpate.app.Main");
  }

  /** Runs java with the libraries of this test in the folder, and returns what it printed. */
  private String run(List<String> first, List<String> arguments) throws Exception {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-cp", System.getProperty("java.class.path")));
    command.addAll(first);
    command.addAll(arguments);
    Process process =
        new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), () -> arguments + "\n" + out);
    return out;
  }
}
