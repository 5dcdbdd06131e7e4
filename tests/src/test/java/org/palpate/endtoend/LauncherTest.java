package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Runs a copy of the launcher in a checkout that holds nothing but what it looks for. */
class LauncherTest {
  private static final List<String> SOURCES =
      List.of("core/src/main", "native/src/main", "plugin/src/main", "benchmarks/src/main");

  @TempDir private Path folder;

  /** A folder in place of the lock file cannot be written to, not even by root. */
  @Test
  void aCheckoutThatCannotBeWrittenToIsRefusedInOneLine() throws Exception {
    Path checkout = makeCheckout();
    Files.createDirectories(checkout.resolve(".palpate").resolve("lock"));
    Process process =
        new ProcessBuilder("sh", checkout.resolve("palpate").toString(), "info")
            .redirectErrorStream(true)
            .start();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(
        "palpate: cannot write to the checkout: "
            + checkout
            + ": copy it to a folder that you may write to\n",
        out);
    assertEquals(1, process.waitFor());
  }

  private Path makeCheckout() throws IOException {
    Assumptions.assumeTrue(Files.isExecutable(Path.of("/bin/sh")), "there is no shell");
    Path checkout = Files.createDirectory(folder.toRealPath().resolve("with a blank"));
    Files.copy(Path.of("..", "palpate"), checkout.resolve("palpate"));
    for (String name : List.of("LICENSE", "pom.xml")) {
      Files.createFile(checkout.resolve(name));
    }
    for (String name : SOURCES) {
      Path sources = Files.createDirectories(checkout.resolve(name));
      Files.createFile(sources.getParent().resolveSibling("pom.xml"));
    }
    return checkout;
  }
}
