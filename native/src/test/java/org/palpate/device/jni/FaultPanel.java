package org.palpate.device.jni;

import java.io.IOException;
import java.nio.ByteOrder;
import java.nio.MappedByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;

/**
 * The memory that a test and a substitute library share; {@code substitutes/panel.h} is its layout.
 */
final class FaultPanel {
  private static final int NAME_BYTES = 40;
  private static final int FAULT = 40;
  private static final int RELEASED = 44;
  private static final int UNPLUGGED = 48;
  private static final int OVERLAPS = 56;
  private static final int TICK_MICROS = 76;
  private static final int FORCE = 104;
  private static final int CALLED_COUNT = 176;
  private static final int CALLED = 184;
  private static final int CALLED_BYTES = 48;
  private static final int BYTES = CALLED + 96 * CALLED_BYTES;

  private final MappedByteBuffer bytes;

  FaultPanel(Path file) throws IOException {
    try (FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
      bytes = channel.map(FileChannel.MapMode.READ_WRITE, 0, BYTES);
      bytes.order(ByteOrder.nativeOrder());
    }
  }

  void clear() {
    for (int i = 0; i < BYTES; i++) {
      bytes.put(i, (byte) 0);
    }
    bytes.putInt(TICK_MICROS, 100);
  }

  void arm(String call, int fault) {
    bytes.put(0, call.getBytes(StandardCharsets.US_ASCII));
    bytes.putInt(FAULT, fault);
  }

  void release() {
    bytes.putInt(RELEASED, 1);
  }

  boolean isUnplugged() {
    return bytes.getInt(UNPLUGGED) != 0;
  }

  int overlaps() {
    return bytes.getInt(OVERLAPS);
  }

  /** Returns the sum of the absolute components of the last force that reached the device. */
  double force() {
    return Math.abs(bytes.getDouble(FORCE))
        + Math.abs(bytes.getDouble(FORCE + 8))
        + Math.abs(bytes.getDouble(FORCE + 16));
  }

  /** Returns the names of the functions called since the panel was cleared. */
  List<String> called() {
    List<String> names = new ArrayList<>();
    for (int i = 0; i < bytes.getInt(CALLED_COUNT); i++) {
      byte[] name = new byte[NAME_BYTES];
      bytes.get(CALLED + i * CALLED_BYTES, name);
      names.add(new String(name, StandardCharsets.US_ASCII).replace("\0", ""));
    }
    return names;
  }
}
