package org.palpate.benchmarks.hold;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.stream.IntStream;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.body.Mobility;
import org.palpate.body.Placement;
import org.palpate.device.HapticDevice;
import org.palpate.frame.ToolFrame;
import org.palpate.geometry.Pose;
import org.palpate.host.ContactScene;
import org.palpate.host.ContactSettings;
import org.palpate.host.SessionSettings;
import org.palpate.host.SessionView;
import org.palpate.host.ToolScene;
import org.palpate.host.TouchSession;
import org.palpate.host.placing.HeldReadings;
import org.palpate.host.placing.LiveReadings;
import org.palpate.loop.LoopEnd;
import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.scene.WorldAxes;
import org.palpate.scene.window.GraphicsDriver;
import org.palpate.scene.window.SceneWindow;
import org.palpate.volume.SegmentedVolume;
import org.palpate.volume.phantom.FracturePhantom;

/**
 * A live session in which a simulated hand holds a fragment among the others of a bone. As in
 * {@code touch}, a real-time thread runs the frames, and a window draws and shows readings. The
 * session has a process of its own.
 */
final class HoldSession {
  private static final double RATE_HZ = 1000;
  private static final double NANOS_PER_SECOND = 1e9;
  private static final long SEED = 1;

  /** Time for the hand to take hold, and for the session to end. */
  private static final double SPARE_SECONDS = 5;

  private final double warmUpSeconds;
  private final double seconds;
  private final SegmentedVolume fragments;
  private final ToolScene scene;
  private final HeldFragment held;

  private HoldSession(FracturePhantom phantom, int points, double warmUpSeconds, double seconds) {
    this.warmUpSeconds = warmUpSeconds;
    this.seconds = seconds;
    fragments = phantom.fragments().segments();
    scene =
        ToolScene.ofPoint(
            new ContactScene(fragments, inPlace(), ContactSettings.standard(), Optional.empty()));
    held = HeldFragment.of(fragments, scene.movableShapes(), points);
  }

  /** Returns placements of all fragments where they belong. The largest is fixed. */
  private List<Placement> inPlace() {
    return IntStream.range(0, fragments.segments().size())
        .mapToObj(n -> new Placement(n == 0 ? Mobility.FIXED : Mobility.MOVABLE, new Pose()))
        .toList();
  }

  /**
   * Runs a session and prints its figures, a line each.
   *
   * @param arguments the phantom, the wanted number of sample points of the fragment in hand, the
   *     seconds before the counted ones, the counted seconds, and whether there is a window
   */
  public static void main(String[] arguments) {
    PrintStream out = System.out;
    System.setOut(System.err); // libraries may print to the usual output
    HoldSession session =
        new HoldSession(
            FracturePhantom.parse(arguments[0]),
            Integer.parseInt(arguments[1]),
            Double.parseDouble(arguments[2]),
            Double.parseDouble(arguments[3]));
    List<RigidFigure> figures = session.run(Boolean.parseBoolean(arguments[4]));
    figures.forEach(figure -> out.println(HoldFigures.line(figure)));
    out.flush();
    System.exit(0); // the threads of a window would keep the JVM alive
  }

  private List<RigidFigure> run(boolean hasWindow) {
    LoopSettings loop = LoopSettings.ofRate(RATE_HZ);
    double longest = warmUpSeconds + seconds + SPARE_SECONDS;
    HapticDevice hand = held.hand(SEED, longest, loop.periodNanos());
    try (RealtimeThread realtime = RealtimeThread.recommended(loop.periodNanos())) {
      FrameMeter meter = new FrameMeter(realtime, (int) (RATE_HZ * longest));
      SessionSettings settings = SessionSettings.standard().withLoop(loop.with(meter, realtime));
      try (TouchSession session = new TouchSession(scene, hand, settings)) {
        meter.measure(session.toolFrame().orElseThrow());
        List<RigidFigure> drawn = hasWindow ? show(session, hand) : run(session);
        List<RigidFigure> figures = new ArrayList<>();
        figures.add(HoldFigures.of("points of the fragment in hand", held.points(), ""));
        figures.addAll(drawn);
        figures.addAll(HoldFigures.of(meter.from(warmUpSeconds)));
        return figures;
      }
    }
  }

  /** Runs a session without a window. */
  private List<RigidFigure> run(TouchSession session) {
    session.start();
    finish(session, session::takeUpdates);
    return List.of();
  }

  /** Runs a session with a window and returns how much was drawn. */
  private List<RigidFigure> show(TouchSession session, HapticDevice hand) {
    GraphicsDriver.prepare();
    List<Pose> starts = Collections.nCopies(fragments.segments().size(), new Pose());
    HeldReadings readings = new HeldReadings(fragments, starts, Optional.empty());
    ToolFrame frame = session.toolFrame().orElseThrow();
    Listener listener = new Listener();
    try (SessionView view = new SessionView(session, fragments, WorldAxes.UNKNOWN, hand, listener);
        LiveReadings lines = new LiveReadings(frame, readings, fragments, view, List::of)) {
      session.start();
      view.start();
      lines.start();
      finish(session, () -> {});
      return List.of(
          HoldFigures.of("triangles in a picture", (double) listener.drawnTriangles(), ""),
          HoldFigures.of("pictures", view.redraws() / session.report().seconds(), "1/s"));
    }
  }

  /** Waits until the session has lasted long enough, and ends it. */
  private void finish(TouchSession session, Runnable tick) {
    long startNanos = 0;
    boolean over = false;
    while (!over && !session.supervise()) {
      tick.run();
      LockSupport.parkNanos(TouchSession.SUPERVISION_PERIOD_NANOS);
      boolean started = session.status().frames() > 0;
      startNanos = started && startNanos != 0 ? startNanos : System.nanoTime();
      over = System.nanoTime() - startNanos > NANOS_PER_SECOND * (warmUpSeconds + seconds);
    }
    LoopEnd end = session.stop();
    if (end.cause() != LoopEnd.Cause.STOPPED) {
      throw new IllegalStateException("the session ended early: " + end.cause(), end.failure());
    }
    System.err.println("real time: " + session.report().granted().schedulingClass());
  }

  /** Prints what a view reports, and keeps its window. Nobody is there to close it. */
  private static final class Listener implements SessionView.Listener {
    private volatile SceneWindow window;

    @Override
    public void print(String line) {
      System.err.println(line);
    }

    @Override
    public void stop() {
      print("the window was closed");
    }

    @Override
    public void opening(SceneWindow opened) {
      window = opened;
    }

    long drawnTriangles() {
      SceneWindow shown = window;
      return shown == null ? 0 : shown.drawnTriangles();
    }
  }
}
