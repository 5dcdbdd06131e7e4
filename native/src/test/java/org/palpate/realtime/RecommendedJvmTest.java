package org.palpate.realtime;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class RecommendedJvmTest {
  @Test
  void asksForGenerationsIfTheyAreNotTheOnlyChoice() {
    assertEquals(List.of("-XX:+UseZGC", "-XX:-UsePerfData"), flags(17).subList(0, 2));
    assertEquals(
        List.of("-XX:+UseZGC", "-XX:+ZGenerational", "-XX:-UsePerfData"), flags(21).subList(0, 3));
    assertEquals(flags(17), flags(25));
  }

  @Test
  void reportsWhichFlagsAreSetAndWhichAreMissing() {
    List<String> lines = RecommendedJvm.explain(25, List.of("-XX:+UseZGC", "-Xmx1g"));
    assertTrue(lines.get(0).startsWith("-XX:+UseZGC: set: "), lines.get(0));
    assertTrue(lines.get(1).startsWith("-XX:-UsePerfData: missing: "), lines.get(1));
  }

  @Test
  void theLauncherSetsTheRecommendedFlags() throws IOException {
    Path launcher = Path.of("../palpate");
    Assumptions.assumeTrue(Files.exists(launcher), "skipped: no launcher beside this module");
    String text = Files.readString(launcher);
    for (String flag : flags(21)) {
      assertTrue(text.contains(flag), flag);
    }
  }

  @Test
  void theCompilerIsToldAboutMethodsThatExist() throws ClassNotFoundException {
    Pattern method = Pattern.compile("-XX:CompileCommand=\\w+,([\\w.]+)::(\\w+)");
    List<Matcher> named = flags(17).stream().map(method::matcher).filter(Matcher::matches).toList();
    assertEquals(1, named.size());
    for (Matcher flag : named) {
      Class<?> type = Class.forName(flag.group(1));
      assertTrue(
          Arrays.stream(type.getDeclaredMethods()).anyMatch(m -> m.getName().equals(flag.group(2))),
          flag.group());
    }
  }

  private static List<String> flags(int release) {
    return RecommendedJvm.of(release).stream().map(RecommendedJvm.Setting::flag).toList();
  }
}
