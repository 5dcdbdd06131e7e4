package org.palpate.device.jni;

import java.nio.ByteBuffer;

/**
 * All native methods of Palpate; {@code jni/shims.cpp} is the C++ side. A handle never becomes
 * invalid: after its device is closed, the calls report that the device is gone.
 */
final class NativeCalls {
  /** A result of {@link #close}, as are the following. */
  static final int ZERO_SENT = 0;

  static final int UNREACHABLE = 1;
  static final int HUNG = 2;
  static final int ALREADY_CLOSED = 3;

  private NativeCalls() {}

  /** Returns the handle, or 0 with the reason in {@code why[0]}. */
  static native long open(String backend, String id, int waitMillis, String[] why);

  /** Returns lines of key, tab and value; null if the back end does not exist. */
  static native String probe(String backend, int waitMillis);

  /**
   * Returns the lines of a capture of a device that speaks the HID protocol; null with the reason
   * in {@code why[0]}.
   */
  static native String capture(String backend, String id, int waitMillis, String[] why);

  /** Returns the bytes described by {@link FrameLayout}, which outlive the device. */
  static native ByteBuffer frame(long handle);

  /**
   * Returns lines of key, tab and value; fills the numbers in the order of {@link NativeDevice}.
   */
  static native String specification(long handle, double[] numbers);

  /** Returns the ordinal of a {@code ReadStatus}. */
  static native int read(long handle);

  /** Whether the device accepted the force. */
  static native boolean write(long handle);

  /** Returns one of the results above. */
  static native int close(long handle, int waitMillis);

  /** Returns the reason why the device is gone; empty while it works. */
  static native String ending(long handle);

  /**
   * Returns the number of threads in a vendor's open, probe or close call, hanging ones included.
   */
  static native int underWay();

  /** Does nothing; {@code HidPeersBenchmark} measures with it the cost of a native call. */
  static native void nothing();
}
