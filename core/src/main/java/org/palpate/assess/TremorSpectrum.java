package org.palpate.assess;

import java.util.OptionalDouble;
import org.palpate.geometry.Vec3;

/**
 * The power spectral density of the motion of the hand, by the method of Welch: the mean over
 * windows that overlap by half, each without its linear trend and weighted by Hann's window.
 *
 * <p>A session of less than a window has no spectrum. Only the frequencies up to {@link
 * #MOST_HERTZ} are of interest, so each is a plain Fourier sum over a window. Cost: about a
 * millisecond for each half window.
 *
 * <p>Reference: P. Welch, The use of fast Fourier transform for the estimation of power spectra,
 * IEEE Trans. Audio Electroacoust. 15 (1967). One thread.
 */
public final class TremorSpectrum {
  /** The band in which tremor is sought, Hz: below it a hand moves as it wants. */
  public static final double LOW_HERTZ = 4;

  /** The upper end of the band, Hz. */
  public static final double HIGH_HERTZ = 12;

  /** The highest frequency of the spectrum, Hz. */
  static final double MOST_HERTZ = 30;

  /** The number of positions in a window. */
  static final int WINDOW = 1024;

  private static final double HERTZ_A_LINE = 1 / (WINDOW * SteadyPath.INTERVAL_SECONDS);
  private static final int LINES = (int) (MOST_HERTZ / HERTZ_A_LINE);

  private final double[][] positions = new double[3][WINDOW];
  private final double[] weighted = new double[WINDOW];
  private final double[] cosines = new double[WINDOW];
  private final double[] hann = new double[WINDOW];
  private final double[] sums = new double[LINES + 1];
  private int held;
  private int windows;

  /** Makes a spectrum of no position. */
  TremorSpectrum() {
    for (int n = 0; n < WINDOW; n++) {
      cosines[n] = Math.cos(2 * Math.PI * n / WINDOW);
      hann[n] = 0.5 * (1 - cosines[n]);
    }
  }

  /** Adds the mean position of the next interval of a {@link SteadyPath}. */
  void add(Vec3 positionMm, boolean begins) {
    if (begins) {
      held = 0;
    }
    for (int axis = 0; axis < 3; axis++) {
      positions[axis][held] = positionMm.get(axis);
    }
    held++;
    if (held == WINDOW) {
      addWindow();
      held = WINDOW / 2;
      for (double[] axis : positions) {
        System.arraycopy(axis, WINDOW - held, axis, 0, held);
      }
    }
  }

  private void addWindow() {
    for (double[] axis : positions) {
      weigh(axis);
      for (int line = 1; line <= LINES; line++) {
        sums[line] += square(line);
      }
    }
    windows++;
  }

  /** Writes the positions of an axis without their linear trend, weighted by the window. */
  private void weigh(double[] axis) {
    double middle = (WINDOW - 1) / 2.0;
    double mean = 0;
    double moment = 0;
    double squares = 0;
    for (int n = 0; n < WINDOW; n++) {
      mean += axis[n] / WINDOW;
      moment += (n - middle) * axis[n];
      squares += (n - middle) * (n - middle);
    }
    double slope = moment / squares;
    for (int n = 0; n < WINDOW; n++) {
      weighted[n] = hann[n] * (axis[n] - mean - slope * (n - middle));
    }
  }

  /** Returns the squared length of the Fourier sum of the weighted positions. */
  private double square(int line) {
    double real = 0;
    double imaginary = 0;
    for (int n = 0; n < WINDOW; n++) {
      int phase = line * n % WINDOW;
      real += weighted[n] * cosines[phase];
      imaginary += weighted[n] * cosines[(phase + WINDOW / 4) % WINDOW];
    }
    return real * real + imaginary * imaginary;
  }

  /** {@return the number of lines; 0 if the session was too short} Lines count from 1. */
  public int lines() {
    return windows == 0 ? 0 : LINES;
  }

  /**
   * {@return the frequency of a line, Hz}
   *
   * @param line the number of the line, from 1
   */
  public double hertz(int line) {
    return line * HERTZ_A_LINE;
  }

  /**
   * {@return the power spectral density at a line, mm^2/Hz, summed over the axes} It makes up for
   * what the means over intervals take from fast motions.
   *
   * @param line the number of the line, from 1
   */
  public double density(int line) {
    double power = 0;
    for (double weight : hann) {
      power += weight * weight;
    }
    double half = Math.PI * hertz(line) * SteadyPath.INTERVAL_SECONDS;
    double kept = Math.sin(half) / half;
    return 2 * SteadyPath.INTERVAL_SECONDS * sums[line] / (windows * power * kept * kept);
  }

  /** {@return the root mean square of the motion in the band of tremor, mm; empty if unknown} */
  public OptionalDouble rmsMm() {
    double square = 0;
    for (int line = 1; line <= lines(); line++) {
      square += isInBand(line) ? density(line) * HERTZ_A_LINE : 0;
    }
    return windows == 0 ? OptionalDouble.empty() : OptionalDouble.of(Math.sqrt(square));
  }

  /** {@return the frequency of the highest peak in the band of tremor, Hz; empty without one} */
  public OptionalDouble peakHertz() {
    int best = 0;
    for (int line = 2; line < lines(); line++) {
      boolean isPeak = sums[line] > sums[line - 1] && sums[line] >= sums[line + 1];
      if (isPeak && isInBand(line) && sums[line] > sums[best]) {
        best = line;
      }
    }
    return best == 0 ? OptionalDouble.empty() : OptionalDouble.of(hertz(best));
  }

  private boolean isInBand(int line) {
    return hertz(line) >= LOW_HERTZ && hertz(line) <= HIGH_HERTZ;
  }
}
