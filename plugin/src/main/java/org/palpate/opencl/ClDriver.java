package org.palpate.opencl;

/**
 * The calls of OpenCL that judging needs: one device with a program, and one queue that works in
 * order. Every call may throw any {@link RuntimeException} or {@link LinkageError}; afterwards
 * nothing is certain, and the caller gives the driver up.
 *
 * <p>One thread at a time. {@link #write}, {@link #launch}, {@link #startRead} and {@link #isRead}
 * allocate nothing and do not wait for the device.
 */
interface ClDriver {
  /** Returns the name of the device. */
  String name();

  /** Whether the device runs on the processors of the host, which a busy wait takes from it. */
  boolean sharesProcessors();

  /** Allocates memory, bytes. */
  ClMemory allocate(long bytes);

  /**
   * Returns a handle of a kernel whose arguments are bound.
   *
   * @param arguments memories and ints, in order
   */
  long kernel(String kernelName, Object... arguments);

  /** Begins to copy the first bytes of a memory from the host to the device. */
  void write(ClMemory memory, int bytes);

  /** Launches at least this number of work items. */
  void launch(long kernel, int items);

  /** Begins to copy the first bytes of a memory from the device to the host. */
  void startRead(ClMemory memory, int bytes);

  /** Whether the last read has ended. Once it has, {@link #startRead} may be called again. */
  boolean isRead();

  /** Frees everything. No other call may follow. */
  void release();
}
