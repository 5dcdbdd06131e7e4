package org.palpate.app.output;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;

/**
 * One axis of a plot.
 *
 * @param label quantity and unit; if empty, the axis has no numbers
 * @param low its lower end, positive on a logarithmic axis
 * @param high its upper end, above the lower one
 * @param isLogarithmic whether equal ratios have equal lengths
 */
record PlotAxis(String label, double low, double high, boolean isLogarithmic) {
  private static final int TICKS = 5;

  /** Below it a tick has an exponent. */
  private static final double SMALL = 1e-4;

  /** Digits of a tick: fewer than those in which sums of steps are inexact. */
  private static final MathContext DIGITS = new MathContext(6);

  /** Makes an axis that begins at zero. */
  static PlotAxis fromZero(String label, double high) {
    return new PlotAxis(label, 0, high > 0 && Double.isFinite(high) ? high : 1, false);
  }

  /** Returns where a value lies between two ends of the picture, beyond them if it is outside. */
  double place(double value, double from, double to) {
    double fraction =
        isLogarithmic
            ? Math.log(Math.max(value, low) / low) / Math.log(high / low)
            : (value - low) / (high - low);
    return from + fraction * (to - from);
  }

  /** Returns round values between the ends; none if the axis has no label. */
  List<Double> ticks() {
    List<Double> ticks = new ArrayList<>();
    if (label.isEmpty()) {
      return ticks;
    }
    double step = isLogarithmic ? 10 : step();
    double first = isLogarithmic ? power(low) : Math.ceil(low / step) * step;
    for (int n = 0; n <= 4 * TICKS; n++) {
      double tick = isLogarithmic ? first * Math.pow(10, n) : first + n * step;
      if (tick > high * (1 + 1e-9) && tick - high > 1e-9 * step) {
        break;
      }
      ticks.add(tick);
    }
    return ticks;
  }

  private static double power(double value) {
    return Math.pow(10, Math.ceil(Math.log10(value) - 1e-9));
  }

  private double step() {
    double rough = (high - low) / TICKS;
    double power = Math.pow(10, Math.floor(Math.log10(rough)));
    for (double factor : new double[] {1, 2, 5}) {
      if (factor * power >= rough) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  /** Returns the text of a tick. */
  static String text(double tick) {
    BigDecimal rounded = new BigDecimal(tick).round(DIGITS).stripTrailingZeros();
    return Math.abs(tick) < SMALL ? rounded.toString() : rounded.toPlainString();
  }
}
