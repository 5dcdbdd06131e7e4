package org.palpate.app.command;

import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.palpate.app.options.DeviceChoice;
import org.palpate.app.output.ElasticFields;
import org.palpate.app.output.FaultFields;
import org.palpate.app.output.MassFields;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.device.HapticDevice;
import org.palpate.frame.FrameStatistics;
import org.palpate.host.MouseTakeover;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.io.file.CountText;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopReport;
import org.palpate.loop.Quantiles;
import org.palpate.loop.ThreadSetup;
import org.palpate.sync.SyncCounters;

/** Reports what a session measured and how it ended. */
final class TouchReport {
  private final TouchSession session;
  private final LoopEnd end;
  private final DeviceChoice choice;
  private final HapticDevice device;
  private final SessionSupervisor supervisor;
  private final Optional<SessionView> view;
  private final long throttled;
  private final LoopReport loop;

  /**
   * Creates the report of a session that has ended.
   *
   * @param throttled how often the kernel's throttling of real-time threads was observed
   */
  TouchReport(
      TouchSession session,
      LoopEnd end,
      DeviceChoice choice,
      HapticDevice device,
      SessionSupervisor supervisor,
      Optional<SessionView> view,
      long throttled) {
    this.session = session;
    this.end = end;
    this.choice = choice;
    this.device = device;
    this.supervisor = supervisor;
    this.view = view;
    this.throttled = throttled;
    loop = session.report();
  }

  /** Whether the last frame was whole. */
  boolean endedInOrder() {
    return end.isInOrder();
  }

  /** Whether a person may have moved the device, and not a simulated hand or a recording alone. */
  boolean isByHand() {
    return isByHand(choice, device);
  }

  static boolean isByHand(DeviceChoice choice, HapticDevice device) {
    boolean isTakenOver = device instanceof MouseTakeover hand && hand.isTakenOver();
    return isTakenOver || !(choice.device().isSimulated() || choice.device().isReplay());
  }

  /**
   * Returns 0 if the session ended regularly.
   *
   * @throws PalpateException exit code 1, if it failed
   * @throws OutOfMemoryError if memory ran out
   */
  int exitCode() {
    if (session.endedByTrouble()) {
      throw PalpateException.failed(
          session.elasticTrouble().orElseThrow(),
          "--elastic",
          "run it again with --debug and report the output",
          session.elasticFailure().orElse(null));
    }
    return exitCode(end, choice, device.ending());
  }

  /**
   * Returns 0 if a session ended regularly.
   *
   * @param ending the reason that the device gives for its disconnection, or nothing
   * @throws PalpateException exit code 1, if it failed
   * @throws OutOfMemoryError if memory ran out
   */
  static int exitCode(LoopEnd end, DeviceChoice choice, String ending) {
    switch (end.cause()) {
      case FAILED -> {
        if (end.failure() instanceof OutOfMemoryError tooLittle) {
          throw tooLittle; // whoever runs the command says how to get more
        }
        throw PalpateException.failed(
            "the session failed (" + end.failure() + ")",
            "device " + choice,
            "run it again with --debug and report the output",
            end.failure());
      }
      case HUNG ->
          throw PalpateException.failed(
              "no frame began for more than a second",
              "device " + choice,
              "the force was ended by closing the device; check its cable and driver, and what else"
                  + " keeps the processors busy",
              null);
      case DEVICE_GONE -> {
        if (!choice.ends()) {
          throw PalpateException.failed(
              "the device disconnected" + (ending.isEmpty() ? "" : " (" + ending + ")"),
              "device " + choice,
              "check its cable and power; its own watchdog ends any remaining force",
              null);
        }
      }
      case STOPPED -> {}
    }
    return 0;
  }

  /** Prints a summary. */
  void print(PrintWriter out) {
    FrameStatistics counts = loop.statistics();
    out.println(
        String.format(
            Locale.ROOT,
            "%.1f s at %.1f Hz: %,d frames, %,d late, %,d in contact, set free %d times,"
                + " largest force %.2f N",
            loop.seconds(),
            loop.rateHz(),
            loop.frames(),
            loop.lateFrames(),
            counts.contactFrames(),
            counts.freed(),
            counts.maxForceNewton()));
    out.println(
        String.format(
            Locale.ROOT,
            "work %.1f us, 99 %% under %.1f us, at most %.1f us; real time: %s",
            loop.workMicros().p50(),
            loop.workMicros().p99(),
            loop.workMicros().max(),
            loop.granted().schedulingClass()));
    out.println(lateness(loop.latenessMicros()));
    session.elastic().ifPresent(body -> out.println(ElasticFields.line(body.counters())));
    if (undosRefused() > 0) {
      String times = CountText.of(undosRefused(), "time");
      out.println("undo refused: a body has come there since (" + times + ")");
    }
    loop.granted().refusals().forEach(refusal -> out.println("real time: " + refusal));
    out.flush();
  }

  /** Returns how late frames began, as a line. */
  static String lateness(Quantiles micros) {
    return String.format(
        Locale.ROOT,
        "lateness %.1f us, 99 %% under %.1f us, at most %.1f us",
        micros.p50(),
        micros.p99(),
        micros.max());
  }

  /** Returns about the time of a frame after the first one, s, by the mean rate. */
  double secondsOf(long frame) {
    return frame / loop.rateHz();
  }

  /** Returns the length of the longest torque, N mm. */
  double maxTorqueNewtonMm() {
    return loop.statistics().maxTorqueNewtonMm();
  }

  /** Returns the most points of the tool that kept less than their clearance in any frame. */
  int mostReducedPoints() {
    return session.mostReducedPoints();
  }

  /** Returns the faults that the frames of a rigid tool met. */
  Map<String, Object> toolFaults() {
    return FaultFields.ofTool(loop.statistics().faults());
  }

  /** Returns how often undo or redo of a placement was refused. */
  private long undosRefused() {
    return session.toolFrame().map(frame -> frame.voxels().history().refused()).orElse(0L);
  }

  /** Adds the fields of a session to a report. */
  void putInto(Report report) {
    FrameStatistics counts = loop.statistics();
    report
        .put("seconds", loop.seconds())
        .put("rate_hz", loop.rateHz())
        .put("frames", loop.frames())
        .put("late_frames", loop.lateFrames())
        .put("period_us", quantiles(loop.periodMicros()))
        .put("lateness_us", quantiles(loop.latenessMicros()))
        .put("work_us", quantiles(loop.workMicros()))
        .put("contact_frames", counts.contactFrames())
        .put("freed", counts.freed())
        .put("max_force_n", counts.maxForceNewton())
        .put("device", choice.toString())
        .put("stiffness_n_per_mm", session.tuning().force().stiffnessNewtonPerMm())
        .put("friction", session.tuning().force().friction())
        .put("realtime", granted(loop.granted()))
        .put("sync", sync())
        .put("skipped", skipped(counts))
        .put("faults", FaultFields.of(counts.faults()))
        .put("end", end.cause().name().toLowerCase(Locale.ROOT));
    putStart(report, counts);
    session.mass().ifPresent(body -> report.put("mass", MassFields.of(body)));
    session.elastic().ifPresent(body -> report.put("elastic", ElasticFields.of(body)));
  }

  /**
   * Adds when the force was switched on. If the hand can hold bodies, adds when it first held one,
   * and how often undo was refused.
   */
  private void putStart(Report report, FrameStatistics counts) {
    OptionalLong forceOn = supervisor.forceOnMillis();
    report.put("force_on_s", forceOn.isPresent() ? secondsFromStart(forceOn.getAsLong()) : null);
    if (session.canHold()) {
      OptionalLong hold = counts.firstHold();
      report.put(
          "first_hold_s",
          forceOn.isPresent() && hold.isPresent()
              ? secondsFromStart(forceOn.getAsLong()) + secondsOf(hold.getAsLong())
              : null);
      report.put("undos_refused", undosRefused());
    }
  }

  private Map<String, Object> skipped(FrameStatistics counts) {
    Map<String, Object> fields = new LinkedHashMap<>(counts.skipped());
    fields.put("unchanged_frames", session.syncCounters().unchanged());
    fields.put("unchanged_nodes", view.map(SessionView::staticReused).orElse(0L));
    fields.put("unseen_nodes", view.map(SessionView::culledBricks).orElse(0L));
    return fields;
  }

  private static Map<String, Object> quantiles(Quantiles micros) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("p50", micros.p50());
    fields.put("p99", micros.p99());
    fields.put("p99_9", micros.p999());
    fields.put("max", micros.max());
    return fields;
  }

  private Map<String, Object> granted(ThreadSetup.Granted granted) {
    Map<String, Object> fields = new LinkedHashMap<>();
    fields.put("class", granted.schedulingClass());
    fields.put("affinity", granted.affinity());
    fields.put("memory_lock", granted.memoryLocked());
    fields.putAll(granted.others());
    fields.put("throttled", throttled);
    fields.put("refused", granted.refusals());
    return fields;
  }

  private Map<String, Object> sync() {
    SyncCounters counts = session.syncCounters();
    Map<String, Object> fields = new LinkedHashMap<>();
    double watchedSeconds = supervisor.seconds();
    double tickRateHz = watchedSeconds > 0 ? session.ticks() / watchedSeconds : 0;
    fields.put("rate_hz", view.map(SessionView::rateHz).orElse(tickRateHz));
    fields.put("writes", counts.writes());
    fields.put("applied", counts.applied());
    fields.put("redraws", view.map(SessionView::redraws).orElse(0L));
    view.map(SessionView::firstSurfaceMillis)
        .filter(millis -> millis > 0)
        .ifPresent(millis -> fields.put("first_picture_s", secondsFromStart(millis)));
    return fields;
  }

  private static double secondsFromStart(long millis) {
    return (millis - ManagementFactory.getRuntimeMXBean().getStartTime()) / 1e3;
  }
}
