package org.palpate.realtime.os;

import com.sun.jna.Memory;
import com.sun.jna.Pointer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/**
 * What the kernel counts about the calling thread: one thread an instance, made and read by it.
 * Reading takes two system calls, about a microsecond, and allocates nothing. All zero on a system
 * without such counters.
 */
public final class ThreadCounters implements AutoCloseable {
  private static final int TEXT_BYTES = 96;
  // struct rusage of 64-bit Linux, as 8-byte fields:
  //   0-3 user and system time   4 maxrss   8 minflt   9 majflt   16 nvcsw   17 nivcsw
  private static final int USAGE_BYTES = 18 * Long.BYTES;
  private static final int MAJOR_FAULTS = 9 * Long.BYTES;
  private static final int INVOLUNTARY_SWITCHES = 17 * Long.BYTES;

  private final Memory memory = new Memory(TEXT_BYTES + USAGE_BYTES);
  private final long address = Pointer.nativeValue(memory);
  private final ByteBuffer bytes =
      memory.getByteBuffer(0, TEXT_BYTES + USAGE_BYTES).order(ByteOrder.nativeOrder());
  private int schedstat = -1;
  private boolean usable;
  private long delayedNanos;
  private long preempted;
  private long majorFaults;

  /** Opens the counters of the calling thread. */
  public ThreadCounters() {
    memory.clear();
    try {
      schedstat =
          LinuxLibrary.open(
              "/proc/thread-self/schedstat", LinuxLibrary.O_RDONLY | LinuxLibrary.O_CLOEXEC);
      usable = OperatingSystem.isLinux();
    } catch (LinkageError e) {
      usable = false; // no C library that JNA can call
    }
  }

  /** Takes new values. */
  public void read() {
    if (!usable) {
      return;
    }
    if (schedstat >= 0) {
      long length = LinuxLibrary.pread(schedstat, address, TEXT_BYTES, 0);
      delayedNanos = secondNumber((int) length);
    }
    LinuxLibrary.getrusage(LinuxLibrary.RUSAGE_THREAD, address + TEXT_BYTES);
    preempted = bytes.getLong(TEXT_BYTES + INVOLUNTARY_SWITCHES);
    majorFaults = bytes.getLong(TEXT_BYTES + MAJOR_FAULTS);
  }

  /** The file reads {@code time-on-processor time-ready-to-run slices}. */
  private long secondNumber(int length) {
    int at = 0;
    while (at < length && bytes.get(at) != ' ') {
      at++;
    }
    long number = 0;
    for (at++; at < length && bytes.get(at) != ' '; at++) {
      number = 10 * number + bytes.get(at) - '0';
    }
    return number;
  }

  /** How long the thread was ready to run and did not, in all, ns. */
  public long delayedNanos() {
    return delayedNanos;
  }

  /** How often the thread was put off its processor, in all. */
  public long preempted() {
    return preempted;
  }

  /** Pages that had to come from a disk, in all. */
  public long majorFaults() {
    return majorFaults;
  }

  @Override
  public void close() {
    if (schedstat >= 0) {
      LinuxLibrary.close(schedstat);
      schedstat = -1;
      usable = false;
    }
  }
}
