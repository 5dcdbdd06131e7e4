package org.palpate.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sessions and replays above 1 kHz. */
class RateCommandTest {
  @TempDir Path folder;

  /** Writes a hand that slides over the ball of {@code sphere:32} and stops there. */
  private Path sliding(int hertz) throws IOException {
    StringBuilder rows = new StringBuilder("t_ms,x,y,z\n");
    for (int n = 0; n <= 6 * hertz; n++) {
      double t = (double) n / hertz;
      double x = 10 + 3 * Math.min(t, 4);
      double z = 30 - 7 * Math.min(1, t / 2) + 0.3 * Math.sin(2 * Math.PI * 8 * t);
      rows.append(String.format(Locale.ROOT, "%.6f,%.9f,16,%.9f%n", 1000 * t, x, z));
    }
    return Files.writeString(folder.resolve(hertz + ".csv"), rows.toString());
  }

  private Path assessed(int hertz, Object... more) throws IOException {
    Path training = folder.resolve("training" + hertz);
    List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
    replay.addAll(List.of("--trajectory", sliding(hertz), "--assess", training));
    replay.addAll(List.of(more));
    CommandRun.of(replay.toArray()).mustSucceed();
    return training.resolve("assessment.json");
  }

  @ParameterizedTest
  @CsvSource({
    "5000, --friction-form, cone",
    "10000, --friction-form, cone",
    "10000, --tool, sphere:2",
    "10000, --mass, 0.02",
    "10000, --effect, stickslip:0.2",
    "10000, --effect, viscosity:0.002",
    "10000, --guide, 'axis:14,16,33,1,0,0'"
  })
  void aHandFeelsTheSameAtEveryRate(int hertz, String option, String value) throws IOException {
    Path slow = assessed(1000, option, value);
    Path fast = assessed(hertz, option, value);
    for (String key : List.of("seconds", "hand_path_mm", "rms_mm")) {
      double expected = FlatJson.number(slow, key);
      assertEquals(expected, FlatJson.number(fast, key), 0.01 * expected, key);
    }
    // The implicit Euler method damps a mass by its step.
    double path = FlatJson.number(slow, "tool_path_mm");
    assertEquals(path, FlatJson.number(fast, "tool_path_mm"), 0.1 * path);
    double force = FlatJson.number(slow, "max_force_n");
    assertTrue(force > 0.2, "it presses: " + force);
    assertEquals(force, FlatJson.number(fast, "max_force_n"), 0.03 * force);
    assertEquals(
        FlatJson.number(slow, "mean_force_n"),
        FlatJson.number(fast, "mean_force_n"),
        0.03 * force,
        "mean force");
  }

  @Test
  void aFastSessionIsRecordedAndReplaysInItsOwnTime() throws IOException {
    Path report = folder.resolve("r.json");
    Path record = folder.resolve("t.csv");
    Path live = folder.resolve("live");
    Object[] touch = {
      "touch",
      "--phantom",
      "sphere:32",
      "--headless",
      "--seconds",
      2,
      "--rate",
      10_000,
      "--record",
      record,
      "--report",
      report,
      "--assess",
      live
    };
    CommandRun run = CommandRun.of(touch);
    run.mustSucceed();
    assertFalse(run.out().contains("samples a second"), "the simulated hand is as fast");
    assertTrue(FlatJson.number(report, "frames") > 2000, "frames");
    assertTrue(Files.readString(report).contains("\"lateness_us\""));
    List<String> rows = Files.readAllLines(record);
    assertTrue(rows.get(2).startsWith("0.1,"), rows.get(2));
    for (boolean raw : new boolean[] {false, true}) {
      Path again = folder.resolve("again" + raw);
      List<Object> replay = new ArrayList<>(List.of("replay", "--phantom", "sphere:32"));
      replay.addAll(List.of("--trajectory", record, "--assess", again));
      if (raw) {
        replay.add("--raw-device");
      }
      CommandRun.of(replay.toArray()).mustSucceed();
      for (String key : List.of("frames", "seconds", "hand_path_mm", "tool_path_mm")) {
        double was = FlatJson.number(live.resolve("assessment.json"), key);
        assertEquals(was, FlatJson.number(again.resolve("assessment.json"), key), 1e-6 * was, key);
      }
    }
  }
}
