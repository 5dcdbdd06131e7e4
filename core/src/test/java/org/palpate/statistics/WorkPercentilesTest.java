package org.palpate.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;

class WorkPercentilesTest {
  @Test
  void aPercentileIsTheWorkOfTheFrameAtThatRank() {
    long[] work = LongStream.rangeClosed(1, 2000).map(n -> 2001 - n).toArray();
    assertEquals(new WorkPercentiles(1000, 1980, 1998, 2000), WorkPercentiles.of(work));
    assertEquals(2000, work[0], "the input keeps its order");
  }

  @Test
  void ofOneFrameAllPercentilesAreItsWork() {
    assertEquals(new WorkPercentiles(7, 7, 7, 7), WorkPercentiles.of(new long[] {7}));
  }

  @Test
  void ofNoFrameAllPercentilesAreZero() {
    assertEquals(new WorkPercentiles(0, 0, 0, 0), WorkPercentiles.of(new long[0]));
  }
}
