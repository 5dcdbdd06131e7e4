package org.palpate.device.protocol;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;

/**
 * Checks how a device answers the force reports (report 2) of the host: whether it names the last
 * one that it received, and whether its watchdog zeroes the force when no more arrive. A device
 * passes without ever producing a force.
 */
final class ForceRules {
  static final int LENGTH = 24;
  static final int ID = 2;

  /** The delay that a watchdog may have: a device looks at it only between two reports. */
  private static final long SLACK_MICROS = 10_000;

  private final List<HidCapture.Report> sent;
  private final List<InReport> in;
  private final Capabilities capabilities;
  private final List<CheckResult> results;

  ForceRules(
      HidCapture capture, List<InReport> in, Capabilities capabilities, List<CheckResult> results) {
    sent = capture.reports().stream().filter(report -> !report.fromDevice()).toList();
    this.in = in;
    this.capabilities = capabilities;
    this.results = results;
  }

  /** Checks the answers; the last report that was sent ends the session and is not answered. */
  void check() {
    if (sent.size() < 2) {
      results.add(CheckResult.note(false, "the device answers report 2", "the capture holds none"));
      return;
    }
    checkHeard();
    checkForceOff();
    checkWatchdog();
  }

  private void checkHeard() {
    Map<Integer, Integer> echoes = new HashMap<>();
    for (HidCapture.Report report : sent) {
      echoes.put(sequence(report), report.bytes().signed32(20));
    }
    long answered = 0;
    long wrongEcho = 0;
    for (InReport report : in) {
      boolean known = report.heard() > 0 && echoes.containsKey(report.heard());
      answered += known ? 1 : 0;
      wrongEcho += known && echoes.get(report.heard()) != report.echoedMicros() ? 1 : 0;
    }
    results.add(
        CheckResult.of(
            answered > 0,
            "heard is the sequence of the last report 2",
            answered + " of " + in.size() + " name one that was sent"));
    results.add(
        CheckResult.of(
            wrongEcho == 0,
            "echoed time is the time field of that report 2",
            wrongEcho + " have another time"));
  }

  private void checkForceOff() {
    long on = in.stream().filter(report -> report.has(InReport.FORCE_ON)).count();
    results.add(
        CheckResult.of(
            on == 0, "the force is off while none is wanted", on + " state that it is on"));
  }

  /** Measures on the device's clock, so that a busy computer changes nothing. */
  private void checkWatchdog() {
    HidCapture.Report last = sent.get(sent.size() - 2);
    Optional<InReport> heard = firstAfter(last, r -> r.heard() == sequence(last));
    Optional<InReport> tripped = firstAfter(last, r -> r.has(InReport.WATCHDOG_ZEROED));
    String rule = "the watchdog trips in its time when the computer falls silent (state bit 3)";
    if (heard.isEmpty()) {
      results.add(CheckResult.note(false, rule, "the last report 2 was not heard"));
    } else if (tripped.isPresent()) {
      long after = micros(heard.get(), tripped.get()) / 1000;
      long latest = capabilities.watchdogMillis() + SLACK_MICROS / 1000;
      results.add(
          CheckResult.of(after <= latest, rule, "after " + after + " ms, at most " + latest));
      checkTrips(last.micros());
    } else {
      long silence = micros(heard.get(), in.get(in.size() - 1));
      boolean longEnough = silence > 1000L * capabilities.watchdogMillis() + SLACK_MICROS;
      results.add(
          longEnough
              ? CheckResult.of(false, rule, "it never did: force would stay on after a crash")
              : CheckResult.note(false, rule, "the silence was too short to see it"));
    }
  }

  private Optional<InReport> firstAfter(HidCapture.Report sent, Predicate<InReport> wanted) {
    return in.stream().filter(r -> r.hostMicros() > sent.micros()).filter(wanted).findFirst();
  }

  private static int sequence(HidCapture.Report report) {
    return report.bytes().unsigned16(2);
  }

  private static long micros(InReport from, InReport to) {
    return Integer.toUnsignedLong(to.timeMicros() - from.timeMicros());
  }

  private void checkTrips(long silentMicros) {
    int before = 0;
    int after = 0;
    for (InReport report : in) {
      before = report.hostMicros() <= silentMicros ? report.watchdogTrips() : before;
      after = report.watchdogTrips();
    }
    int counted = after - before & 0xFFFF;
    results.add(
        CheckResult.of(
            counted == 1, "the watchdog counts its trips", counted + " counted, 1 caused"));
  }
}
