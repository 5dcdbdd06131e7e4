package org.palpate.benchmarks.hold;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.hold.FrameMeter.Measured;
import org.palpate.benchmarks.rigid.Quantile;
import org.palpate.benchmarks.rigid.RigidFigure;

/** Makes the figures of a session, and hands them from its process to the one that prints them. */
final class HoldFigures {
  private static final String STUDY = "hold";
  private static final String SEPARATOR = "\t";
  private static final String NO_CONDITION = "";
  private static final double MOST_PROCESSOR_MICROS = 1000;

  private HoldFigures() {}

  /** Returns the figures of measured frames. */
  static List<RigidFigure> of(Measured frames) {
    List<RigidFigure> figures = new ArrayList<>();
    figures.add(of("frames", frames.frames(), ""));
    figures.add(withTarget("frames without it in hand", 100 * (1 - frames.held()), "%", 0));
    figures.add(of("frames in contact", 100 * frames.touching(), "%"));
    figures.addAll(
        quantiles("processor time", frames.processorMicros(), "us", MOST_PROCESSOR_MICROS));
    figures.addAll(quantiles("work", frames.work(), "points", Double.NaN));
    figures.addAll(lateness(frames.lateMicros()));
    return figures;
  }

  /** Returns figures of the lateness of frames, us. */
  static List<RigidFigure> lateness(double[] micros) {
    return quantiles("lateness", micros, "us", Double.NaN);
  }

  private static List<RigidFigure> quantiles(
      String name, double[] values, String unit, double targetOf999) {
    return List.of(
        of(name + " p50", Quantile.of(values, 0.5), unit),
        of(name + " p99", Quantile.of(values, 0.99), unit),
        withTarget(name + " p99.9", Quantile.of(values, 0.999), unit, targetOf999),
        of(name + " max", Quantile.of(values, 1), unit));
  }

  /** Returns a figure without a target. */
  static RigidFigure of(String name, double value, String unit) {
    return RigidFigure.of(STUDY, NO_CONDITION, name, value, unit);
  }

  private static RigidFigure withTarget(String name, double value, String unit, double target) {
    return new RigidFigure(STUDY, NO_CONDITION, name, value, unit, target);
  }

  /** Returns the same figure of a condition. */
  static RigidFigure in(String condition, RigidFigure figure) {
    return new RigidFigure(
        figure.study(), condition, figure.name(), figure.value(), figure.unit(), figure.target());
  }

  /** Returns a figure as a line without its condition. */
  static String line(RigidFigure figure) {
    return String.join(
        SEPARATOR,
        figure.name(),
        Double.toString(figure.value()),
        figure.unit(),
        Double.toString(figure.target()));
  }

  /** Returns the figure of a line that {@link #line} made. */
  static RigidFigure parse(String line) {
    String[] cells = line.split(SEPARATOR, -1);
    return new RigidFigure(
        STUDY,
        NO_CONDITION,
        cells[0],
        Double.parseDouble(cells[1]),
        cells[2],
        Double.parseDouble(cells[3]));
  }
}
