package org.palpate.benchmarks.crossing;

import com.sun.jna.Native;
import com.sun.jna.Pointer;

/** Binds hidapi by JNA's direct mapping. */
final class JnaHidapi {
  static {
    Native.register(JnaHidapi.class, "hidapi-hidraw");
  }

  private JnaHidapi() {}

  static native Pointer hid_open_path(String path);

  static native int hid_read_timeout(Pointer device, byte[] bytes, long length, int millis);

  static native int hid_write(Pointer device, byte[] bytes, long length);
}
