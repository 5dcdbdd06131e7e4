package org.palpate.recording;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.function.DoubleFunction;
import org.palpate.device.DeviceState;

/**
 * Writes samples as the rows of a trajectory file: {@code t_ms,x,y,z,qx,qy,qz,qw,flags}, times from
 * the first sample's on, positions as the device gave them, NaN and infinities spelt as Java does.
 */
public final class TrajectoryWriter implements SampleRecorder.Sink {
  /** The first line. */
  public static final String HEADER = "t_ms,x,y,z,qx,qy,qz,qw,flags";

  private static final double NANOS_PER_MS = 1e6;

  private final Appendable out;
  private final DoubleFunction<String> number;
  private boolean begun;
  private long firstTimeNanos;

  /**
   * Rows to {@code out}.
   *
   * @param number writes a double so that it reads back the same
   */
  public TrajectoryWriter(Appendable out, DoubleFunction<String> number) {
    this.out = out;
    this.number = number;
  }

  /**
   * Writes a row, and before the first one the header.
   *
   * @throws UncheckedIOException where {@code out} fails
   */
  @Override
  public void accept(DeviceState sample, int flags) {
    try {
      begin(sample);
      value((sample.timeNanos - firstTimeNanos) / NANOS_PER_MS);
      value(sample.positionMm.x);
      value(sample.positionMm.y);
      value(sample.positionMm.z);
      value(sample.qx);
      value(sample.qy);
      value(sample.qz);
      value(sample.qw);
      out.append(Integer.toString(flags)).append('\n');
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

  private void value(double value) throws IOException {
    out.append(number.apply(value)).append(',');
  }
}
