package org.palpate.device.protocol;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** Feature report 3: what a device can do. Immutable. */
record Capabilities(Bytes bytes) {
  static final int LENGTH = 32;
  static final int ID = 3;
  static final int VERSION = 1;
  static final int HAS_HAND_SENSOR = 1;
  private static final int KNOWN_FLAGS = 3;
  private static final byte[] MAGIC = "PLPT".getBytes(StandardCharsets.US_ASCII);
  private static final int[] RESERVED = {23, 24, 26, 27, 28, 29, 30, 31};
  private static final int MOST_WATCHDOG_MILLIS = 100;
  private static final int MOST_INTERVAL_MICROS = 4000;

  /** Whether the report is that of the protocol, of any version. */
  boolean isProtocol() {
    return bytes.length() >= LENGTH && bytes.unsigned8(0) == ID && bytes.startsAt(2, MAGIC);
  }

  /** Whether the report is that of version 1, whose rules are checked. */
  boolean isVersionOne() {
    return isProtocol() && bytes.unsigned8(1) == VERSION;
  }

  int maxForceMilliNewton() {
    return bytes.unsigned16(6);
  }

  double radiusMm() {
    return bytes.unsigned16(14) / 10.0;
  }

  int intervalMicros() {
    return bytes.unsigned16(16);
  }

  int watchdogMillis() {
    return bytes.unsigned16(18);
  }

  int buttons() {
    return bytes.unsigned8(20);
  }

  boolean hasOrientation() {
    return bytes.unsigned8(21) > 3;
  }

  boolean hasHandSensor() {
    return (bytes.unsigned8(25) & HAS_HAND_SENSOR) != 0;
  }

  /** Checks the rules of this report. */
  void check(List<CheckResult> results) {
    results.add(
        CheckResult.of(
            isProtocol(),
            "feature report 3 has 32 bytes and begins with 3, the version and PLPT",
            isProtocol() ? "it does" : bytes.length() + " bytes: answer GET_REPORT for feature 3"));
    if (!isProtocol()) {
      return;
    }
    int version = bytes.unsigned8(1);
    results.add(CheckResult.of(isVersionOne(), "the version is 1", "version " + version));
    if (isVersionOne()) {
      checkForce(results);
      checkTimes(results);
      checkReserved(results);
    }
  }

  private void checkForce(List<CheckResult> results) {
    int lasting = bytes.unsigned16(8);
    int stiffness = bytes.unsigned16(10);
    results.add(CheckResult.of(radiusMm() > 0, "the workspace has a radius", radiusMm() + " mm"));
    results.add(
        CheckResult.of(
            maxForceMilliNewton() == 0 || stiffness > 0,
            "a device with force states a stiffness",
            maxForceMilliNewton() + " mN, " + stiffness + " N/m"));
    results.add(
        CheckResult.of(
            lasting <= maxForceMilliNewton(),
            "the lasting force is no larger than the maximum",
            lasting + " of " + maxForceMilliNewton() + " mN"));
    int in = bytes.unsigned8(21);
    int out = bytes.unsigned8(22);
    results.add(
        CheckResult.of(
            in >= 3 && in <= 7 && out <= 7,
            "3 to 7 degrees of freedom in, at most 7 out",
            in + " in, " + out + " out"));
  }

  private void checkTimes(List<CheckResult> results) {
    results.add(
        CheckResult.of(
            watchdogMillis() > 0, "the device has a watchdog", watchdogMillis() + " ms"));
    results.add(
        CheckResult.note(
            watchdogMillis() <= MOST_WATCHDOG_MILLIS,
            "the watchdog waits for at most " + MOST_WATCHDOG_MILLIS + " ms",
            watchdogMillis() + " ms; 20 ms is usual"));
    results.add(
        CheckResult.of(
            intervalMicros() > 0, "the report interval is stated", intervalMicros() + " us"));
    results.add(
        CheckResult.note(
            intervalMicros() <= MOST_INTERVAL_MICROS,
            "the report interval is short enough for a firm touch",
            intervalMicros() + " us; 1000 us is usual"));
  }

  private void checkReserved(List<CheckResult> results) {
    boolean zero = (bytes.unsigned8(25) & ~KNOWN_FLAGS) == 0;
    for (int at : RESERVED) {
      zero &= bytes.unsigned8(at) == 0;
    }
    results.add(
        CheckResult.of(
            zero,
            "reserved bytes and flags of feature report 3 are 0",
            zero ? "they are" : "a later version may give them a meaning: send 0"));
  }
}
