package org.palpate.benchmarks.speed;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SpeedPlotsTest {
  @Test
  void plotsEveryTableWithConditions(@TempDir Path folder) throws IOException {
    List<SpeedRow> rows = new ArrayList<>();
    for (String place : List.of("free", "near")) {
      for (String caster : List.of("exact", "sampled:1")) {
        Map<String, String> params = new LinkedHashMap<>();
        params.put("place", place);
        params.put("caster", caster);
        List<Double> times = List.of(20.5, 30.0, 4000.0);
        rows.add(new SpeedRow("collision", "cast", params, "ns/op", times, 0));
      }
    }
    rows.add(new SpeedRow("volume", "read", Map.of(), "ns/op", List.of(1.0), 0));
    SpeedPlots.plot(folder, SpeedStudy.ALL, rows);
    assertEquals(1200, ImageIO.read(folder.resolve("speed-collision.png").toFile()).getWidth());
    assertEquals(1, folder.toFile().list().length);
  }

  @Test
  void reportsTheMedianOfEvenAndOddCounts() {
    assertEquals(30, row(20.5, 30.0, 4000.0).median());
    assertEquals(25, row(20.0, 30.0).median());
  }

  private static SpeedRow row(Double... times) {
    return new SpeedRow("group", "name", Map.of(), "ns/op", List.of(times), 0);
  }
}
