package org.palpate.device.protocol;

/**
 * Report 1 of the protocol, which the device sends, unpacked. Immutable.
 *
 * @param state the state flags, such as {@link #FORCE_ON}
 * @param sequence the number of the report, modulo 65536
 * @param timeMicros the device's clock, us
 * @param distanceMm the distance of the position from the origin of the device, mm
 * @param quaternionNorm the norm of the orientation
 * @param buttons the pressed buttons, a bit each
 * @param heard the sequence number of the last force report that the device has received
 * @param fault the code of a fault; 0 for none
 * @param watchdogTrips the number of times that the watchdog has set the force to zero
 * @param echoedMicros the time that the device echoes from that force report, us
 * @param hostMicros the host's time when the report arrived, us
 */
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
