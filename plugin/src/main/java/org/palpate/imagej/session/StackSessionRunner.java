package org.palpate.imagej.session;

import ij.IJ;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.palpate.host.SessionWorker;
import org.palpate.host.TrajectoryRecording;
import org.palpate.imagej.dialog.ErrorDialogs;
import org.palpate.imagej.dialog.PlaceOptions;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopEnd;

/**
 * Runs a session from start to end in a thread of its own, so that the command that started it
 * returns and macros can continue.
 */
public final class StackSessionRunner {
  private final String title;
  private final HandSession session;
  private final Optional<TrajectoryRecording> recording;
  private final SessionWorker worker;

  private StackSessionRunner(
      String title, HandSession session, Optional<TrajectoryRecording> recording) {
    this.title = title;
    this.session = session;
    this.recording = recording;
    worker = new SessionWorker(this::work, session::requestStop);
  }

  /**
   * Starts a session and waits until the force is on.
   *
   * @param recording records what the device sends, if given; closed with the session, also if it
   *     cannot start
   * @throws TouchRefusedException if the session cannot start
   */
  public static void begin(
      StackVolume volume, TouchOptions options, Optional<TrajectoryRecording> recording)
      throws TouchRefusedException {
    begin(
        "Touch Volume",
        () -> new StackSession(volume, options, recording.map(TrajectoryRecording::recorder)),
        recording);
  }

  /**
   * Starts to place the fragments of a label stack, and waits until the force is on.
   *
   * @throws TouchRefusedException if the session cannot start
   */
  public static void begin(StackVolume volume, PlaceOptions options) throws TouchRefusedException {
    begin("Place Fragments", () -> new PlacingSession(volume, options), Optional.empty());
  }

  /** Prepares a session. */
  @FunctionalInterface
  private interface Preparation {
    HandSession prepare() throws TouchRefusedException;
  }

  private static void begin(
      String title, Preparation preparation, Optional<TrajectoryRecording> recording)
      throws TouchRefusedException {
    boolean started = false;
    HandSession session = null;
    try {
      CurrentSession.requireNoneRunning();
      session = preparation.prepare();
      StackSessionRunner run = new StackSessionRunner(title, session, recording);
      CurrentSession.begin(run);
      started = true;
      run.worker.start();
      session.awaitForce();
    } finally {
      if (!started) {
        recording.ifPresent(TrajectoryRecording::close);
      }
      if (!started && session != null) {
        session.close();
      }
    }
  }

  HandSession session() {
    return session;
  }

  /** Waits for the end; returns whether it came in time. */
  boolean await(long millis) {
    return worker.await(millis);
  }

  private void work() {
    try {
      report(touch());
    } catch (TouchRefusedException | RuntimeException e) {
      if (!SessionWorker.isProcessEnding()) {
        ErrorDialogs.show(title, e);
      }
    } catch (OutOfMemoryError e) {
      ErrorDialogs.showOutOfMemory(title);
    }
  }

  /** Runs the session and closes everything, so that another session may start. */
  private LoopEnd touch() throws TouchRefusedException {
    try (HandSession touched = session) {
      LoopEnd end = touched.run();
      touched.finish();
      if (recording.isPresent()) {
        finish(recording.get());
      }
      return end;
    } finally {
      recording.ifPresent(TrajectoryRecording::close);
      CurrentSession.end(this);
    }
  }

  private static void finish(TrajectoryRecording recording) throws TouchRefusedException {
    try {
      recording.finish();
    } catch (IOException e) {
      throw notWritten(recording.target(), e);
    }
  }

  /** Returns the refusal for a trajectory file that cannot be written. */
  public static TouchRefusedException notWritten(Path target, IOException cause) {
    return new TouchRefusedException(
        "The trajectory cannot be written to " + target + ": " + cause.getMessage());
  }

  private void report(LoopEnd end) throws TouchRefusedException {
    IJ.showProgress(1);
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: ended after %d frames, zero force sent",
            session.status().frames()));
    if (end.failure() != null) {
      throw new TouchRefusedException("The session failed: " + end.failure().getMessage());
    }
  }
}
