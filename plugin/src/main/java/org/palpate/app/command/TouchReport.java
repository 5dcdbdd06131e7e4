package org.palpate.app.command;

import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.options.DeviceChoice;
import org.palpate.app.output.FaultFields;
import org.palpate.app.output.Report;
import org.palpate.app.process.PalpateException;
import org.palpate.device.HapticDevice;
import org.palpate.frame.FrameStatistics;
import org.palpate.host.SessionView;
import org.palpate.host.TouchSession;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopReport;
import org.palpate.loop.Quantiles;
import org.palpate.loop.ThreadSetup;
import org.palpate.sync.SyncCounters;

/** What a session measured, and how it ended. */
final class TouchReport {
  private final TouchSession session;
  private final LoopEnd end;
  private final DeviceChoice choice;
  private final HapticDevice device;
  private final double watchedSeconds;
  private final Optional<SessionView> view;
  private final long throttled;
  private final LoopReport loop;

  /**
   * Of a session that has ended.
   *
   * @param throttled how often the kernel was seen to force its rest on the haptic thread
   */
  TouchReport(
      TouchSession session,
      LoopEnd end,
      DeviceChoice choice,
      HapticDevice device,
      double watchedSeconds,
      Optional<SessionView> view,
      long throttled) {
    this.session = session;
    this.end = end;
    this.choice = choice;
    this.device = device;
    this.watchedSeconds = watchedSeconds;
    this.view = view;
    this.throttled = throttled;
    loop = session.report();
  }

  /**
   * 0 where the session ended as it should.
   *
   * @throws PalpateException exit code 1, where it failed
   */
  int exitCode() {
    return exitCode(end, choice, device.ending());
  }

  /**
   * The same of any ending.
   *
   * @param ending what the device tells of its going, or nothing
   */
  static int exitCode(LoopEnd end, DeviceChoice choice, String ending) {
    switch (end.cause()) {
      case FAILED ->
          throw PalpateException.failed(
              "the session failed (" + end.failure() + ")",
              "device " + choice,
              "run it again with --debug and report what it shows",
              end.failure());
      case HUNG ->
          throw PalpateException.failed(
              "a frame did not come back",
              "device " + choice,
              "force was ended by closing the device; look at its cable and driver",
              null);
      case DEVICE_GONE -> {
        if (!choice.ends()) {
          throw PalpateException.failed(
              "the device went away" + (ending.isEmpty() ? "" : " (" + ending + ")"),
              "device " + choice,
              "look at its cable and power; what it still holds its own watchdog ends",
              null);
        }
      }
      case STOPPED -> {}
    }
    return 0;
  }

  /** Tells it in two lines. */
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
    loop.granted().refusals().forEach(refusal -> out.println("real time: " + refusal));
    out.flush();
  }

  /** Adds its fields. */
  void putInto(Report report) {
    FrameStatistics counts = loop.statistics();
    report
        .put("seconds", loop.seconds())
        .put("rate_hz", loop.rateHz())
        .put("frames", loop.frames())
        .put("late_frames", loop.lateFrames())
        .put("period_us", quantiles(loop.periodMicros()))
        .put("work_us", quantiles(loop.workMicros()))
        .put("contact_frames", counts.contactFrames())
        .put("freed", counts.freed())
        .put("max_force_n", counts.maxForceNewton())
        .put("device", choice.toString())
        .put("realtime", granted(loop.granted()))
        .put("sync", sync())
        .put("skipped", skipped(counts))
        .put("faults", FaultFields.of(counts.faults()))
        .put("end", end.cause().name().toLowerCase(Locale.ROOT));
  }

  private Map<String, Object> skipped(FrameStatistics counts) {
    Map<String, Object> fields = new LinkedHashMap<>(counts.skipped());
    fields.put("unchanged_frames", session.syncCounts().unchanged());
    fields.put("unchanged_nodes", view.map(SessionView::stillKept).orElse(0L));
    fields.put("unseen_nodes", view.map(SessionView::skippedBricks).orElse(0L));
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
    SyncCounters counts = session.syncCounts();
    Map<String, Object> fields = new LinkedHashMap<>();
    double unseen = watchedSeconds > 0 ? session.ticks() / watchedSeconds : 0;
    fields.put("rate_hz", view.map(SessionView::rateHz).orElse(unseen));
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
