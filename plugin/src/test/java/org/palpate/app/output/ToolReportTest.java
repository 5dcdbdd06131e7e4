package org.palpate.app.output;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.palpate.host.ToolReplay.MovedBodies;

class ToolReportTest {
  @Test
  void aReplaySaysWhatMovedOutsideTheHand() {
    assertEquals(
        "outside the hand: 0 motions of 3 movable bodies, 0 pushes of the tool, held back 0 times",
        ToolReport.moved(new MovedBodies(3, 0, 0, 0, 0)));
    assertEquals(
        "outside the hand: 1 motion of 1 movable body, 1 push of the tool, held back 1 time",
        ToolReport.moved(new MovedBodies(1, 1, 1, 1, 0)));
  }
}
