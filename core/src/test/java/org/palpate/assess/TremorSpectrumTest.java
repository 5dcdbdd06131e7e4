package org.palpate.assess;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.palpate.geometry.Vec3;
import org.palpate.testing.Seeds;

class TremorSpectrumTest {
  private final TremorSpectrum spectrum = new TremorSpectrum();
  private final SteadyPath path = new SteadyPath(spectrum::add);

  /** A hand that moves on slowly and shakes along two axes. */
  private void shake(double hertz, double amplitudeMm, double rateHertz, double seconds) {
    for (int n = 0; n < seconds * rateHertz; n++) {
      double t = n / rateHertz;
      double angle = 2 * Math.PI * hertz * t;
      double slow = 20 * Math.sin(2 * Math.PI * 0.2 * t) + 3 * t;
      path.add(
          t,
          new Vec3(
              slow + amplitudeMm * Math.sin(angle), 0.5 * amplitudeMm * Math.cos(angle), -slow));
    }
  }

  @ParameterizedTest
  @CsvSource({"5, 250", "8, 500", "8, 1000", "8, 5000", "8, 10000", "11.3, 1000", "11.3, 10000"})
  void aSinusHasItsPowerAndItsFrequencyAtEveryRate(double hertz, double rateHertz) {
    shake(hertz, 0.3, rateHertz, 30);
    double expected = 0.3 * Math.sqrt((1 + 0.25) / 2);
    assertEquals(expected, spectrum.rmsMm().orElseThrow(), 0.01 * expected);
    assertEquals(hertz, spectrum.peakHertz().orElseThrow(), 0.25);
  }

  @Test
  void aHandWithoutTremorHasNone() {
    shake(8, 0, 1000, 30);
    assertTrue(spectrum.rmsMm().orElseThrow() < 0.005, spectrum.rmsMm().toString());
  }

  /** The window spreads a line over its neighbours, so that little of it reaches the band. */
  @ParameterizedTest
  @ValueSource(doubles = {2.5, 13.5, 25})
  void aMotionBesideTheBandIsNoTremor(double hertz) {
    shake(hertz, 0.3, 1000, 30);
    assertTrue(spectrum.rmsMm().orElseThrow() < 0.006, spectrum.rmsMm().toString());
    double peak = spectrum.peakHertz().orElse(8);
    assertTrue(peak >= 4 && peak <= 12, "peak at " + peak);
  }

  @Test
  void aShortSessionHasNoSpectrum() {
    shake(8, 0.3, 1000, 4);
    assertEquals(0, spectrum.lines());
    assertTrue(spectrum.rmsMm().isEmpty());
    assertTrue(spectrum.peakHertz().isEmpty());
  }

  /** Compares with the formula of Welch, written plainly, on a random walk. */
  @Test
  void everyLineIsThatOfThePlainFormula() {
    SplittableRandom random = new SplittableRandom(Seeds.seed());
    int count = 2 * TremorSpectrum.WINDOW;
    double[][] walk = new double[3][count];
    Vec3 position = new Vec3();
    for (int n = 0; n < count; n++) {
      for (int axis = 0; axis < 3; axis++) {
        double before = n == 0 ? 0 : walk[axis][n - 1];
        walk[axis][n] = before + random.nextDouble(-1, 1);
        position.set(axis, walk[axis][n]);
      }
      spectrum.add(position, n == 0);
    }
    for (int line = 1; line <= spectrum.lines(); line += 7) {
      double sum = 0;
      for (int first = 0; first + TremorSpectrum.WINDOW <= count; first += 512) {
        for (double[] axis : walk) {
          sum += plainDensity(axis, first, spectrum.hertz(line)) / 3;
        }
      }
      assertEquals(sum, spectrum.density(line), 1e-9 * sum, "seed " + Seeds.seed());
    }
  }

  private static double plainDensity(double[] axis, int first, double hertz) {
    int count = TremorSpectrum.WINDOW;
    double sumT = 0;
    double sumX = 0;
    double sumTt = 0;
    double sumTx = 0;
    for (int n = 0; n < count; n++) {
      sumT += n;
      sumX += axis[first + n];
      sumTt += (double) n * n;
      sumTx += n * axis[first + n];
    }
    double slope = (count * sumTx - sumT * sumX) / (count * sumTt - sumT * sumT);
    double offset = (sumX - slope * sumT) / count;
    double real = 0;
    double imaginary = 0;
    double weights = 0;
    double seconds = 0.004;
    for (int n = 0; n < count; n++) {
      double weight = Math.pow(Math.sin(Math.PI * n / count), 2);
      double rest = weight * (axis[first + n] - offset - slope * n);
      real += rest * Math.cos(2 * Math.PI * hertz * n * seconds);
      imaginary -= rest * Math.sin(2 * Math.PI * hertz * n * seconds);
      weights += weight * weight;
    }
    double kept = Math.sin(Math.PI * hertz * seconds) / (Math.PI * hertz * seconds);
    return 2 * seconds * (real * real + imaginary * imaginary) / weights / (kept * kept);
  }
}
