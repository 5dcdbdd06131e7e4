package org.palpate.benchmarks.jitter.experiment;

import com.sun.jna.Memory;
import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.palpate.realtime.os.OperatingSystem;

/**
 * Reads the kernel's counters of the calling thread. One thread creates, reads and closes it. A
 * reading takes two system calls, about a microsecond, and allocates nothing. All counters are zero
 * on a system that is not Linux.
 */
final class ThreadCounters implements AutoCloseable {
  private static final int TEXT_BYTES = 96;
  // struct rusage of 64-bit Linux, as 8-byte fields:
  //   0-3 user and system time   4 maxrss   8 minflt   9 majflt   16 nvcsw   17 nivcsw
  private static final int USAGE_BYTES = 18 * Long.BYTES;
  private static final int MAJOR_FAULTS = 9 * Long.BYTES;
  private static final int INVOLUNTARY_SWITCHES = 17 * Long.BYTES;

  /** Binds the C library directly. Source: fcntl.h, unistd.h, sys/resource.h of Linux. */
  private static final class CLibrary {
    static final int RUSAGE_THREAD = 1;
    static final int O_RDONLY = 0;
    static final int O_CLOEXEC = 0x80000;

    static {
      Native.register(CLibrary.class, "c");
    }

    private CLibrary() {}

    static native int open(String path, int flags);

    static native long pread(int descriptor, long buffer, long bytes, long offset);

    static native int close(int descriptor);

    /** Fills the {@code struct rusage} at the given address. */
    static native int getrusage(int who, long usage);
  }

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
  ThreadCounters() {
    memory.clear();
    try {
      schedstat =
          CLibrary.open("/proc/thread-self/schedstat", CLibrary.O_RDONLY | CLibrary.O_CLOEXEC);
      usable = OperatingSystem.isLinux();
    } catch (LinkageError e) {
      usable = false; // no C library that JNA can call
    }
  }

  /** Reads the present values. */
  void read() {
    if (!usable) {
      return;
    }
    if (schedstat >= 0) {
      long length = CLibrary.pread(schedstat, address, TEXT_BYTES, 0);
      delayedNanos = secondNumber((int) length);
    }
    CLibrary.getrusage(CLibrary.RUSAGE_THREAD, address + TEXT_BYTES);
    preempted = bytes.getLong(TEXT_BYTES + INVOLUNTARY_SWITCHES);
    majorFaults = bytes.getLong(TEXT_BYTES + MAJOR_FAULTS);
  }

  /** Returns the second number of {@code time-on-processor time-ready-to-run slices}. */
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

  /** Returns the total time in which the thread was ready but did not run, ns. */
  long delayedNanos() {
    return delayedNanos;
  }

  /** Returns how often another thread took the processor, in total. */
  long preempted() {
    return preempted;
  }

  /** Returns the number of pages that were read from a disk, in total. */
  long majorFaults() {
    return majorFaults;
  }

  @Override
  public void close() {
    if (schedstat >= 0) {
      CLibrary.close(schedstat);
      schedstat = -1;
      usable = false;
    }
  }
}
