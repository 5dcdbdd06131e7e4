package org.palpate.benchmarks.hold;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.palpate.benchmarks.report.OwnProcess;
import org.palpate.benchmarks.rigid.RigidFigure;

class HoldSessionTest {
  @Test
  void theHandHoldsTheFragmentAllTheTimeAndPressesIt() throws IOException, InterruptedException {
    List<String> arguments = List.of("fracture:96:3:1:1", "2000", "3", "1", "false");
    Map<String, RigidFigure> figures =
        OwnProcess.lines(HoldSession.class, List.of(), arguments).stream()
            .map(HoldFigures::parse)
            .collect(Collectors.toMap(RigidFigure::name, Function.identity()));
    assertTrue(figures.get("points of the fragment in hand").value() > 500);
    assertTrue(figures.get("frames").value() > 0);
    assertEquals("met", figures.get("frames without it in hand").verdict());
    assertTrue(figures.get("frames in contact").value() > 10, figures.toString());
    assertTrue(figures.get("processor time p50").value() > 0);
    assertEquals(1000, figures.get("processor time p99.9").target());
  }

  @Test
  void figuresPassThroughALineUnchanged() {
    RigidFigure figure = new RigidFigure("hold", "", "lateness p99.9", 12.25, "us", Double.NaN);
    assertEquals(figure, HoldFigures.parse(HoldFigures.line(figure)));
    RigidFigure count = HoldFigures.of("frames", 3, "");
    assertEquals(count, HoldFigures.parse(HoldFigures.line(count)));
  }
}
