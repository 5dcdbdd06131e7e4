package org.palpate.io.volume;

import java.util.Optional;
import java.util.OptionalInt;

/**
 * What a person may say about how to read.
 *
 * @param raw sizes, type and spacing of a raw file ({@code --raw})
 * @param timeStep which time step or component of a file with several, from 0 ({@code --time})
 * @param series which series of a DICOM folder, a number from the list or its UID ({@code
 *     --series})
 * @param resample whether uneven slices may be brought to even spacing ({@code --resample})
 * @param progress is told while reading
 */
public record ReadOptions(
    Optional<RawLayout> raw,
    OptionalInt timeStep,
    Optional<String> series,
    boolean resample,
    ReadProgress progress) {

  /** No wishes. */
  public static ReadOptions defaults() {
    return new ReadOptions(
        Optional.empty(), OptionalInt.empty(), Optional.empty(), false, ReadProgress.NONE);
  }

  public ReadOptions withRaw(RawLayout layout) {
    return new ReadOptions(Optional.of(layout), timeStep, series, resample, progress);
  }

  public ReadOptions withTimeStep(int step) {
    return new ReadOptions(raw, OptionalInt.of(step), series, resample, progress);
  }

  public ReadOptions withSeries(String wanted) {
    return new ReadOptions(raw, timeStep, Optional.of(wanted), resample, progress);
  }

  public ReadOptions withResample(boolean wanted) {
    return new ReadOptions(raw, timeStep, series, wanted, progress);
  }

  public ReadOptions withProgress(ReadProgress listener) {
    return new ReadOptions(raw, timeStep, series, resample, listener);
  }
}
