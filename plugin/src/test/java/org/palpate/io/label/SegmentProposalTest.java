package org.palpate.io.label;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

class SegmentProposalTest {
  private final Random random = new Random(1);

  @Test
  void bone250AndSkinMinus300AreProposedForHounsfieldUnits() {
    ValueStatistics.Summary found = ct(0);
    assertTrue(found.hounsfield());
    assertEquals(
        List.of(new SegmentProposal("bone", 250, true), new SegmentProposal("skin", -300, true)),
        SegmentProposal.of(found));
    assertTrue(SegmentProposal.reason(found).contains("Hounsfield"));
  }

  @Test
  void cornersThatTheScannerFillsWithALowerValueAreNoObstacle() {
    assertTrue(ct(2000).hounsfield());
  }

  @Test
  void unsignedCtAndOtherScansGetOtsusThresholds() {
    double[] unsigned = values(0);
    Arrays.setAll(unsigned, n -> unsigned[n] + 1024);
    ValueStatistics.Summary found = ValueStatistics.ofSample(unsigned);
    assertFalse(found.hounsfield());
    assertEquals(found.thresholds().get(1), SegmentProposal.of(found).get(0).atLeast());
    assertTrue(SegmentProposal.reason(found).contains("Otsu"));
    double[] noise =
        DoubleStream.generate(() -> -1000 + 4000 * random.nextDouble())
            .limit(100_000)
            .filter(value -> value > -850 || value < -999.9)
            .toArray();
    assertFalse(ValueStatistics.ofSample(noise).hounsfield(), "no air");
  }

  @Test
  void nothingIsProposedForTwoValues() {
    ValueStatistics.Summary found = ValueStatistics.ofSample(new double[] {0.5, 1.5});
    assertEquals(List.of(), SegmentProposal.of(found));
    assertEquals("", SegmentProposal.reason(found));
  }

  private ValueStatistics.Summary ct(int corners) {
    return ValueStatistics.ofSample(values(corners));
  }

  /** Returns values of a CT scan: corners of -3024, half air, and a normal spread of tissues. */
  private double[] values(int corners) {
    double[] values = new double[10_000 + corners];
    for (int n = 0; n < 10_000; n++) {
      double mean = n < 5000 ? -1000 : n < 9000 ? 40 : 900;
      double deviation = n < 5000 ? 20 : n < 9000 ? 60 : 300;
      values[n] = Math.rint(mean + deviation * random.nextGaussian());
    }
    Arrays.fill(values, 10_000, values.length, -3024);
    return values;
  }
}
