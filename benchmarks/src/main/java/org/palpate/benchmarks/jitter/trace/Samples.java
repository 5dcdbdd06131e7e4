package org.palpate.benchmarks.jitter.trace;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.LongBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.stream.IntStream;

/**
 * The samples of a loop's frames, in memory and as a file.
 *
 * <pre>
 *   a frame, six 64-bit integers in the machine's byte order:
 *   0  due        its deadline, ns
 *   1  start      the start of its work
 *   2  end        the end of its work
 *   3  delayed    total time in which the thread was ready but did not run, ns
 *   4  preempted  total number of preemptions
 *   5  faults     total number of pages read from a disk
 * </pre>
 *
 * <p>One thread writes; {@link #add} allocates nothing.
 */
public final class Samples {
  private static final int FIELDS = 6;

  private final long[] values;
  private int count;

  /** Creates room for a number of frames; the memory is already touched. */
  public Samples(int capacity) {
    values = new long[Math.multiplyExact(capacity, FIELDS)];
  }

  /** Adds a frame. */
  public void add(long due, long start, long end, long delayed, long preempted, long faults) {
    int at = count * FIELDS;
    values[at] = due;
    values[at + 1] = start;
    values[at + 2] = end;
    values[at + 3] = delayed;
    values[at + 4] = preempted;
    values[at + 5] = faults;
    count++;
  }

  /** Returns the number of frames. */
  public int count() {
    return count;
  }

  /** Whether the capacity is reached. */
  public boolean isFull() {
    return count * FIELDS == values.length;
  }

  /** Returns the deadline of a frame, ns. */
  public long due(int frame) {
    return values[frame * FIELDS];
  }

  /** Returns the start of a frame's work, ns. */
  long start(int frame) {
    return values[frame * FIELDS + 1];
  }

  /** Returns the end of a frame's work, ns. */
  public long end(int frame) {
    return values[frame * FIELDS + 2];
  }

  /** Returns the time from the deadline to the start, ns. */
  long lateness(int frame) {
    return start(frame) - due(frame);
  }

  /** Returns the time from the deadline to the start of each frame, us. */
  public double[] latenessMicros() {
    return IntStream.range(0, count).mapToDouble(frame -> lateness(frame) / 1e3).toArray();
  }

  /** Returns the duration of the work, ns. */
  long work(int frame) {
    return end(frame) - start(frame);
  }

  /** Returns the time from the deadline to the force, ns: lateness and work. */
  long response(int frame) {
    return end(frame) - due(frame);
  }

  /**
   * Returns the time in which the thread was ready but did not run, from the last frame's end, ns.
   */
  long delayed(int frame) {
    return growth(frame, 3);
  }

  /** Returns the number of preemptions from the end of the last frame. */
  long preempted(int frame) {
    return growth(frame, 4);
  }

  /** Returns the number of pages read from a disk from the end of the last frame. */
  long faults(int frame) {
    return growth(frame, 5);
  }

  private long growth(int frame, int field) {
    return frame == 0 ? 0 : values[frame * FIELDS + field] - values[(frame - 1) * FIELDS + field];
  }

  /** Writes all frames to a file. */
  public void write(Path file) throws IOException {
    ByteBuffer bytes =
        ByteBuffer.allocate(count * FIELDS * Long.BYTES).order(ByteOrder.nativeOrder());
    bytes.asLongBuffer().put(values, 0, count * FIELDS);
    Files.write(file, bytes.array());
  }

  /**
   * Reads a file.
   *
   * @throws IOException if it does not contain a whole number of frames, or none
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
