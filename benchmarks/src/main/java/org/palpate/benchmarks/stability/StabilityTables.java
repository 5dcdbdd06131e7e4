package org.palpate.benchmarks.stability;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.palpate.benchmarks.stability.StabilityStudy.DeviceRow;
import org.palpate.benchmarks.stability.StabilityStudy.TheoryRow;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.file.NumberText;

/** Writes the results as CSV files with a header and exact numbers. */
final class StabilityTables {
  private StabilityTables() {}

  /** Writes the rows of the theory. */
  static void writeTheory(Path file, List<TheoryRow> rows) throws IOException {
    StringBuilder text =
        new StringBuilder(
            "rate_hz,delay_samples,damping_ns_per_m,largest_n_per_m,passive_n_per_m\n");
    for (TheoryRow row : rows) {
      append(
          text,
          number(row.sampling().rateHz()),
          Integer.toString(row.sampling().delaySamples()),
          number(row.damping()),
          number(row.largest()),
          number(row.passive()));
    }
    AtomicFile.write(file, text);
  }

  /** Writes rows of devices or shapes. */
  static void writeDevices(Path file, List<DeviceRow> rows) throws IOException {
    StringBuilder text =
        new StringBuilder(
            "device,grip,shape,solver,rate_hz,delay_samples,handle_kg,damping_ns_per_m,"
                + "default_n_per_m,largest_n_per_m,margin,play_mm,energy_back_mj,rise_n_per_ms\n");
    for (DeviceRow row : rows) {
      Trial trial = row.trial();
      append(
          text,
          trial.device().name(),
          trial.grip().name(),
          trial.shape().name(),
          trial.solver().name(),
          number(trial.sampling().rateHz()),
          Integer.toString(trial.sampling().delaySamples()),
          number(trial.device().handleKg()),
          number(trial.device().dampingNewtonSecondPerM()),
          number(row.defaultStiffness()),
          number(row.largest()),
          number(row.margin()),
          number(row.atDefault().excursionMm()),
          number(row.atDefault().energyBackMillijoule()),
          number(row.atDefault().riseNewtonPerMs()));
    }
    AtomicFile.write(file, text);
  }

  private static String number(double value) {
    return NumberText.text(value);
  }

  private static void append(StringBuilder text, String... cells) {
    text.append(String.join(",", cells)).append('\n');
  }
}
