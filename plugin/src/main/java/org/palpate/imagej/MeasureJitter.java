package org.palpate.imagej;

import ij.IJ;
import ij.Prefs;
import ij.gui.GenericDialog;
import ij.measure.ResultsTable;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.palpate.device.SimulatedDevice;
import org.palpate.geometry.RigidTransform;
import org.palpate.geometry.Vec3;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.TouchSession;
import org.palpate.imagej.dialog.HelpText;
import org.palpate.imagej.session.CurrentSession;
import org.palpate.imagej.session.StackRealtime;
import org.palpate.imagej.stack.SegmentColour;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopReport;
import org.palpate.loop.LoopSettings;
import org.palpate.loop.Quantiles;
import org.palpate.realtime.RealtimeThread;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.VoxelGrid;

/**
 * "Measure Jitter...": measures how regularly ImageJ's own JVM runs a haptic frame a thousand times
 * a second.
 *
 * <p>It measures an ordinary thread and a thread as sessions use it, while a simulated hand touches
 * a ball, and shows the figures in the table "Palpate Jitter". The command {@code palpate jitter}
 * compares other JVMs, collectors and a C++ loop.
 */
public final class MeasureJitter extends PalpateCommand {
  static final String TABLE = "Palpate Jitter";

  private static final String SECONDS = "palpate.jitter";
  private static final double DEFAULT_SECONDS = 10;
  private static final double RATE_HZ = 1000;
  private static final int EDGE = 96;
  private static final long SEED = 1;
  private static final double NANOS_PER_SECOND = 1e9;

  /** Creates the command; ImageJ calls this. */
  public MeasureJitter() {
    super("Measure Jitter");
  }

  @Override
  void execute() throws TouchRefusedException {
    CurrentSession.requireNoneRunning();
    GenericDialog dialog = new GenericDialog("Measure Jitter");
    dialog.addNumericField("Time", Prefs.get(SECONDS, DEFAULT_SECONDS), 1, 8, "s each");
    HelpText.addTo(dialog);
    dialog.showDialog();
    if (dialog.wasCanceled()) {
      return;
    }
    double seconds = dialog.getNextNumber();
    if (dialog.invalidNumber() || !(seconds > 0)) {
      throw new TouchRefusedException("The time must be a positive number of seconds.");
    }
    Prefs.set(SECONDS, seconds);
    IJ.resetEscape();
    ResultsTable table = new ResultsTable();
    LoopSettings plain = LoopSettings.ofRate(RATE_HZ);
    addRows(table, "ordinary thread", measure(plain, seconds));
    try (RealtimeThread realtime = StackRealtime.thread()) {
      addRows(table, "as sessions run", measure(plain.with(realtime, realtime), seconds));
    }
    IJ.showProgress(1);
    IJ.showStatus("Palpate: jitter measured");
    table.show(TABLE);
  }

  private static LoopReport measure(LoopSettings settings, double seconds) {
    ContactScene scene = ball();
    SimulatedDevice hand = new SimulatedDevice(SEED, scene.handTarget(), settings.periodNanos());
    try (TouchSession session =
        new TouchSession(scene, hand, SessionSettings.standard().withLoop(settings))) {
      session.start();
      supervise(session, seconds);
      session.stop();
      return session.report();
    }
  }

  private static void supervise(TouchSession session, double seconds) {
    long startNanos = 0;
    double passedSeconds = 0;
    while (passedSeconds < seconds && !session.supervise() && !IJ.escapePressed()) {
      if (startNanos == 0 && session.status().frames() > 0) {
        startNanos = System.nanoTime();
      }
      passedSeconds = startNanos == 0 ? 0 : (System.nanoTime() - startNanos) / NANOS_PER_SECOND;
      session.takeUpdates();
      IJ.showProgress(passedSeconds / seconds);
      IJ.showStatus("Palpate: measuring jitter; Escape ends");
      LockSupport.parkNanos(TouchSession.SUPERVISION_PERIOD_NANOS);
    }
  }

  private static ContactScene ball() {
    BitCube bits = new BitCube(EDGE, EDGE, EDGE);
    double middle = EDGE / 2.0;
    double radius = EDGE / 3.0;
    for (int k = 0; k < EDGE; k++) {
      for (int j = 0; j < EDGE; j++) {
        for (int i = 0; i < EDGE; i++) {
          double x = i + 0.5 - middle;
          double y = j + 0.5 - middle;
          double z = k + 0.5 - middle;
          if (x * x + y * y + z * z <= radius * radius) {
            bits.set(i, j, k);
          }
        }
      }
    }
    VoxelGrid grid = new VoxelGrid(EDGE, EDGE, EDGE, new Vec3(1, 1, 1), RigidTransform.identity());
    Segment segment = new Segment("ball", bits, SegmentColour.BONE.rgb());
    return new ContactScene(
        new SegmentedVolume(grid, List.of(segment)), ContactSettings.standard());
  }

  private static void addRows(ResultsTable table, String thread, LoopReport report) {
    addRow(table, thread + ", period (us)", report.periodMicros(), report);
    addRow(table, thread + ", work (us)", report.workMicros(), report);
  }

  private static void addRow(ResultsTable table, String what, Quantiles micros, LoopReport report) {
    table.incrementCounter();
    table.addValue("What", what);
    table.addValue("Median", micros.p50());
    table.addValue("99 %", micros.p99());
    table.addValue("99.9 %", micros.p999());
    table.addValue("Largest", micros.max());
    table.addValue("Frames", (double) report.frames());
    table.addValue("Late", (double) report.lateFrames());
    table.addValue("Class", report.granted().schedulingClass());
  }
}
