package org.palpate.device.jni;

import java.nio.ByteBuffer;

/**
 * Every native method there is; the C++ side is {@code jni/shims.cpp}. A handle may be used for
 * ever: once its device is closed the calls answer as for one that is gone.
 */
final class NativeCalls {
  /** Answers of {@link #close}. */
  static final int ZERO_SENT = 0;

  static final int UNREACHABLE = 1;
  static final int HUNG = 2;
  static final int ALREADY_CLOSED = 3;

  private NativeCalls() {}

  /** The handle, or 0 with {@code why[0]} set. */
  static native long open(String backend, String id, int waitMillis, String[] why);

  /** Lines of key, tab, value; null for a back end that does not exist. */
  static native String probe(String backend, int waitMillis);

  /** A line a back end. */
  static native String backends();

  /** The bytes described by {@link FrameLayout}; they outlive the device. */
  static native ByteBuffer frame(long handle);

  /** Lines of key, tab, value; numbers in the order of {@link NativeDevice}. */
  static native String specification(long handle, double[] numbers);

  static native int read(long handle);

  static native boolean write(long handle);

  static native int close(long handle, int waitMillis);

  static native String ending(long handle);

  /** How many threads are inside a vendor's opening, looking or closing, hanging ones too. */
  static native int underWay();

  /** Nothing at all: the yardstick of what the others cost. */
  static native void nothing();
}
