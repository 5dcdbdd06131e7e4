package org.palpate.device.protocol;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Predicate;

/** Checks the reports of a capture one by one and in their order. One thread. */
final class ReportRules {
  private static final double QUATERNION_TOLERANCE = 0.01;
  private static final double INTERVAL_TOLERANCE = 0.2;
  private static final double REACH_TOLERANCE = 0.1;

  private final Capabilities capabilities;
  private final List<CheckResult> results;
  private final List<InReport> in = new ArrayList<>();
  private int wrongLength;
  private int wrongId;

  ReportRules(HidCapture capture, Capabilities capabilities, List<CheckResult> results) {
    this.capabilities = capabilities;
    this.results = results;
    capture.reports().stream().filter(HidCapture.Report::fromDevice).forEach(this::take);
  }

  /** Takes the bytes of one read, in which some systems join several whole reports. */
  private void take(HidCapture.Report report) {
    Bytes bytes = report.bytes();
    if (bytes.length() == 0 || bytes.length() % InReport.LENGTH != 0) {
      wrongLength++;
      return;
    }
    for (int at = 0; at < bytes.length(); at += InReport.LENGTH) {
      if (bytes.unsigned8(at) == InReport.ID) {
        in.add(InReport.unpack(bytes, at, report.micros()));
      } else {
        wrongId++;
      }
    }
  }

  /** Returns the unpacked reports in the order in which they came. */
  List<InReport> reports() {
    return in;
  }

  /** Checks everything that needs no force. */
  void check() {
    results.add(
        CheckResult.of(
            wrongLength == 0 && !in.isEmpty(),
            "report 1 comes, with 48 bytes",
            in.size() + " of 48 bytes, " + wrongLength + " of another length"));
    results.add(
        CheckResult.of(
            wrongId == 0, "the first byte of report 1 is 1", wrongId + " begin with another byte"));
    if (in.size() > 1) {
      checkOrder();
      checkTime();
    }
    checkContent();
  }

  private void checkOrder() {
    int lost = 0;
    int old = 0;
    for (int i = 1; i < in.size(); i++) {
      int step = (short) (in.get(i).sequence() - in.get(i - 1).sequence());
      lost += Math.max(0, step - 1);
      old += step < 1 ? 1 : 0;
    }
    results.add(
        CheckResult.of(
            old == 0, "the sequence rises with each report", old + " repeat or go back"));
    results.add(
        CheckResult.note(
            lost == 0, "the sequence has no gaps", lost + " are missing, by device or computer"));
  }

  /** Compares the device's clock with its sequence, so that a busy computer changes nothing. */
  private void checkTime() {
    double[] intervals = new double[in.size() - 1];
    for (int i = 1; i < in.size(); i++) {
      InReport last = in.get(i - 1);
      int steps = Math.max(1, in.get(i).sequence() - last.sequence() & 0xFFFF);
      int micros = in.get(i).timeMicros() - last.timeMicros();
      intervals[i - 1] = (double) Integer.toUnsignedLong(micros) / steps;
    }
    Arrays.sort(intervals);
    double median = intervals[intervals.length / 2];
    int stated = capabilities.intervalMicros();
    results.add(
        CheckResult.of(
            Math.abs(median - stated) <= INTERVAL_TOLERANCE * stated,
            "the device's clock is in us and advances by the report interval",
            Math.round(median) + " us a report, " + stated + " us stated"));
  }

  private void checkContent() {
    all(
        "the quaternion has the norm 1, or is 0 without an orientation",
        r ->
            Math.abs(r.quaternionNorm() - 1) <= QUATERNION_TOLERANCE
                || (r.quaternionNorm() == 0 && !capabilities.hasOrientation()));
    all(
        "the position is in um, within the stated radius",
        r -> r.distanceMm() <= (1 + REACH_TOLERANCE) * capabilities.radiusMm());
    all(
        "only buttons that the device has are pressed",
        r -> r.buttons() >>> Math.min(capabilities.buttons(), 16) == 0);
    all("reserved bits of the state are 0", r -> !r.hasReservedState());
    all("no fault is reported", r -> r.fault() == 0);
    all(
        "without a hand sensor the hand counts as present",
        r -> capabilities.hasHandSensor() || r.has(InReport.HAND_PRESENT));
  }

  private void all(String rule, Predicate<InReport> holds) {
    long broken = in.stream().filter(holds.negate()).count();
    results.add(CheckResult.of(broken == 0, rule, broken + " of " + in.size() + " break it"));
  }
}
