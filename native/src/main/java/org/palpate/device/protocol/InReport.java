package org.palpate.device.protocol;

/** A report of the device, unpacked. Immutable. */
record InReport(
    int state,
    int sequence,
    int timeMicros,
    double distanceMm,
    double quaternionNorm,
    int buttons,
    int heard,
    int fault,
    int watchdogTrips,
    int echoedMicros,
    long hostMicros) {
  static final int LENGTH = 48;
  static final int ID = 1;
  static final int HAND_PRESENT = 1 << 1;
  static final int FORCE_ON = 1 << 2;
  static final int WATCHDOG_ZEROED = 1 << 3;
  private static final int KNOWN_STATES = 31;

  /** Unpacks the report at an offset. */
  static InReport unpack(Bytes from, int at, long hostMicros) {
    double x = from.signed32(at + 8) / 1000.0;
    double y = from.signed32(at + 12) / 1000.0;
    double z = from.signed32(at + 16) / 1000.0;
    double norm2 = 0;
    for (int i = 0; i < 4; i++) {
      double component = from.signed16(at + 20 + 2 * i) / 32767.0;
      norm2 += component * component;
    }
    return new InReport(
        from.unsigned8(at + 1),
        from.unsigned16(at + 2),
        from.signed32(at + 4),
        Math.sqrt(x * x + y * y + z * z),
        Math.sqrt(norm2),
        from.unsigned16(at + 34),
        from.unsigned16(at + 38),
        from.unsigned8(at + 40),
        from.unsigned16(at + 42),
        from.signed32(at + 44),
        hostMicros);
  }

  boolean has(int flag) {
    return (state & flag) != 0;
  }

  boolean hasReservedState() {
    return (state & ~KNOWN_STATES) != 0;
  }
}
