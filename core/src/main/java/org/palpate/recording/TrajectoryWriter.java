package org.palpate.recording;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.DoubleFunction;
import org.palpate.device.DeviceState;

/**
 * Writes samples as the rows of a trajectory file, {@code t_ms,x,y,z,qw,qx,qy,qz,flags}.
 *
 * <p>Times are milliseconds from the first sample. Positions are those of the device; NaN and
 * infinities are spelt as in Java. One thread.
 */
public final class TrajectoryWriter implements SampleRecorder.Sink {
  /** The first line of a trajectory file. */
  public static final String HEADER = "t_ms,x,y,z,qw,qx,qy,qz,flags";

  /** The code in the column {@code flags} of a sample at which the device jumped. */
  public static final int RELOCATED_FLAG = 4;

  private static final double NANOS_PER_MS = 1e6;

  private final Appendable out;
  private final DoubleFunction<String> number;
  private boolean begun;
  private long firstTimeNanos;

  /**
   * Makes a writer.
   *
   * @param out receives the header and the rows
   * @param number spells a double so that it reads back bit for bit
   */
  public TrajectoryWriter(Appendable out, DoubleFunction<String> number) {
    this.out = out;
    this.number = number;
  }

  /**
   * Writes a row, after the header if it is the first.
   *
   * @throws UncheckedIOException if {@code out} fails
   */
  @Override
  public void accept(DeviceState sample, SampleFlags flags) {
    try {
      begin(sample);
      append((sample.timeNanos - firstTimeNanos) / NANOS_PER_MS);
      append(sample.positionMm.x);
      append(sample.positionMm.y);
      append(sample.positionMm.z);
      append(sample.orientation.w);
      append(sample.orientation.x);
      append(sample.orientation.y);
      append(sample.orientation.z);
      int code = flags.code() + (sample.relocated ? RELOCATED_FLAG : 0);
      out.append(Integer.toString(code)).append('\n');
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void begin(DeviceState sample) throws IOException {
    if (!begun) {
      begun = true;
      firstTimeNanos = sample.timeNanos;
      out.append(HEADER).append('\n');
    }
  }

  private void append(double value) throws IOException {
    out.append(number.apply(value)).append(',');
  }
}
