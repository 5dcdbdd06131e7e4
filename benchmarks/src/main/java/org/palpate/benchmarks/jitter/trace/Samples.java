package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.LongBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;

/**
 * What a loop noted of every frame, in memory and as a file.
 *
 * <pre>
 *   a frame, six 64-bit integers in the machine's byte order:
 *   0  due        when it should have begun, ns
 *   1  start      when it began
 *   2  end        when its work was done
 *   3  delayed    how long the thread was ready to run and did not, in all, ns
 *   4  preempted  how often it was put off its processor, in all
 *   5  faults     pages that had to come from a disk, in all
 * </pre>
 *
 * <p>One thread writes; {@link #note} allocates nothing.
 */
public final class Samples {
  private static final int FIELDS = 6;

  private final long[] values;
  private int count;

  /** Room for so many frames, already touched. */
  public Samples(int capacity) {
    values = new long[Math.multiplyExact(capacity, FIELDS)];
  }

  /** Notes one more frame. */
  public void note(long due, long start, long end, long delayed, long preempted, long faults) {
    int at = count * FIELDS;
    values[at] = due;
    values[at + 1] = start;
    values[at + 2] = end;
    values[at + 3] = delayed;
    values[at + 4] = preempted;
    values[at + 5] = faults;
    count++;
  }

  /** How many frames there are. */
  public int count() {
    return count;
  }

  public boolean isFull() {
    return count * FIELDS == values.length;
  }

  public long due(int frame) {
    return values[frame * FIELDS];
  }

  long start(int frame) {
    return values[frame * FIELDS + 1];
  }

  public long end(int frame) {
    return values[frame * FIELDS + 2];
  }

  /** How late the frame began, ns. */
  long lateness(int frame) {
    return start(frame) - due(frame);
  }

  /** How long its work took, ns. */
  long work(int frame) {
    return end(frame) - start(frame);
  }

  /** How late its force was out, ns: the lateness and the work. */
  long response(int frame) {
    return end(frame) - due(frame);
  }

  /** How long the thread was ready and did not run since the frame before was done, ns. */
  long delayed(int frame) {
    return growth(frame, 3);
  }

  /** How often it was put off its processor since the frame before was done. */
  long preempted(int frame) {
    return growth(frame, 4);
  }

  /** Pages that had to come from a disk since the frame before was done. */
  long faults(int frame) {
    return growth(frame, 5);
  }

  private long growth(int frame, int field) {
    return frame == 0 ? 0 : values[frame * FIELDS + field] - values[(frame - 1) * FIELDS + field];
  }

  /** Writes all frames. */
  public void write(Path file) throws IOException {
    ByteBuffer bytes =
        ByteBuffer.allocate(count * FIELDS * Long.BYTES).order(ByteOrder.nativeOrder());
    bytes.asLongBuffer().put(values, 0, count * FIELDS);
    Files.write(file, bytes.array());
  }

  /**
   * Reads a file.
   *
   * @throws IOException where it is no whole number of frames, or holds none
   */
  public static Samples read(Path file) throws IOException {
    try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ)) {
      long size = channel.size();
      if (size == 0 || size % (FIELDS * Long.BYTES) != 0) {
        throw new IOException("not a file of samples: " + file + " bytes=" + size);
      }
      LongBuffer longs =
          channel
              .map(FileChannel.MapMode.READ_ONLY, 0, size)
              .order(ByteOrder.nativeOrder())
              .asLongBuffer();
      Samples samples = new Samples(longs.remaining() / FIELDS);
      longs.get(samples.values);
      samples.count = samples.values.length / FIELDS;
      return samples;
    }
  }
}
