package org.palpate.io.volume;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * Options for reading a volume.
 *
 * @param raw size, type and spacing of a raw file ({@code --raw})
 * @param timeStep the time step or component of a file with several, from 0 ({@code --time})
 * @param series the series of a DICOM folder, by its number in the list or by its UID ({@code
 *     --series})
 * @param resample whether unevenly spaced slices may be interpolated ({@code --resample})
 * @param progress receives the progress of reading
 */
public record ReadOptions(
    Optional<RawLayout> raw,
    OptionalInt timeStep,
    Optional<String> series,
    boolean resample,
    ReadProgress progress) {

  /** Returns options that choose nothing. */
  public static ReadOptions defaults() {
    return new ReadOptions(
        Optional.empty(), OptionalInt.empty(), Optional.empty(), false, ReadProgress.NONE);
  }

  /** Returns these options with a raw layout. */
  public ReadOptions withRaw(RawLayout layout) {
    return new ReadOptions(Optional.of(layout), timeStep, series, resample, progress);
  }

  /** Returns these options with a time step, from 0. */
  public ReadOptions withTimeStep(int step) {
    return new ReadOptions(raw, OptionalInt.of(step), series, resample, progress);
  }

  /** Returns these options with a DICOM series, by number or UID. */
  public ReadOptions withSeries(String wanted) {
    return new ReadOptions(raw, timeStep, Optional.of(wanted), resample, progress);
  }

  /** Returns these options with interpolation of unevenly spaced slices allowed or not. */
  public ReadOptions withResample(boolean wanted) {
    return new ReadOptions(raw, timeStep, series, wanted, progress);
  }

  /** Returns these options with a receiver of progress. */
  public ReadOptions withProgress(ReadProgress listener) {
    return new ReadOptions(raw, timeStep, series, resample, listener);
  }
}
