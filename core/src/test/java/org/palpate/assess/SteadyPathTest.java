package org.palpate.assess;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;

class SteadyPathTest {
  private final List<Double> means = new ArrayList<>();
  private int pieces;
  private final SteadyPath path =
      new SteadyPath(
          (mean, begins) -> {
            means.add(mean.x);
            pieces += begins ? 1 : 0;
          });

  @ParameterizedTest
  @ValueSource(doubles = {20, 100, 333, 1000, 5000, 10_000})
  void aStraightPathHasItsLengthAtEveryRate(double hertz) {
    int count = (int) (2 * hertz) + 1;
    for (int n = 0; n < count; n++) {
      path.add(n / hertz, new Vec3(30 * n / hertz, 40 * n / hertz, 0));
    }
    path.endPiece();
    assertEquals(100, path.lengthMm(), 1e-9);
    assertEquals(1, pieces);
    assertEquals(2 / SteadyPath.INTERVAL_SECONDS, means.size(), 1, "an interval of 4 ms each");
  }

  @ParameterizedTest
  @ValueSource(doubles = {1000, 5000, 10_000})
  void aCircleHasItsLengthAtEveryRate(double hertz) {
    for (int n = 0; n <= hertz; n++) {
      double angle = 2 * Math.PI * n / hertz;
      path.add(n / hertz, new Vec3(5 * Math.cos(angle), 5 * Math.sin(angle), 1));
    }
    path.endPiece();
    assertEquals(10 * Math.PI, path.lengthMm(), 0.01);
  }

  @Test
  void theNoiseOfADeviceAddsLessThanBetweenSamples() {
    double betweenSamples = 0;
    for (int n = 0; n < 10_000; n++) {
      double quantized = 0.02 * (n % 2);
      path.add(n / 10_000.0, new Vec3(quantized, 0, 0));
      betweenSamples += n > 0 ? 0.02 : 0;
    }
    path.endPiece();
    assertEquals(200, betweenSamples, 0.1);
    assertEquals(0, path.lengthMm(), 0.1);
  }

  @Test
  void aJumpBetweenPiecesIsNoPath() {
    path.add(0, new Vec3(0, 0, 0));
    path.add(0.1, new Vec3(1, 0, 0));
    path.endPiece();
    path.add(0.101, new Vec3(50, 0, 0));
    path.add(0.2, new Vec3(52, 0, 0));
    path.endPiece();
    assertEquals(3, path.lengthMm(), 1e-12);
    assertEquals(2, pieces);
  }

  @Test
  void intervalsWithoutASampleLieOnTheStraightLine() {
    path.add(0.001, new Vec3(1, 0, 0));
    path.add(0.021, new Vec3(6, 0, 0));
    path.add(0.025, new Vec3(7, 0, 0));
    assertEquals(List.of(1.0, 2.0, 3.0, 4.0, 5.0, 6.0), means);
  }

  /** The means end before the last sample, which is in the middle of an interval. */
  @Test
  void aPieceEndsAtItsLastSample() {
    for (int n = 0; n <= 2_002; n++) {
      path.add(n / 1000.0, new Vec3(0, 0, n));
    }
    path.endPiece();
    assertEquals(2_002, path.lengthMm(), 1e-9);
  }

  @Test
  void theLongestGapIsFilledAndALongerOneIsNot() {
    long most = Math.round(SteadyPath.LONGEST_GAP_SECONDS / SteadyPath.INTERVAL_SECONDS);
    double middle = SteadyPath.INTERVAL_SECONDS / 2;
    path.add(middle, new Vec3());
    path.add(middle + most * SteadyPath.INTERVAL_SECONDS, new Vec3(most, 0, 0));
    path.add(middle + (2 * most + 1) * SteadyPath.INTERVAL_SECONDS, new Vec3());
    path.endPiece();
    assertEquals(most + 2, means.size(), "a mean for each interval of the first gap alone");
    assertEquals(1, means.get(1), 1e-9);
    assertEquals(2, pieces);
  }

  @Test
  void aLongGapIsAPathButNoMotionForASpectrum() {
    path.add(0, new Vec3(0, 0, 0));
    path.add(1, new Vec3(3, 0, 0));
    path.endPiece();
    assertEquals(3, path.lengthMm(), 1e-12);
    assertEquals(List.of(0.0, 3.0), means);
    assertEquals(2, pieces);
  }
}
