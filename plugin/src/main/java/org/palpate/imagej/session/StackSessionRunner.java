package org.palpate.imagej.session;

import ij.IJ;
import java.util.Locale;
import java.util.Optional;
import org.palpate.host.SessionWorker;
import org.palpate.imagej.dialog.ErrorDialogs;
import org.palpate.imagej.dialog.TouchOptions;
import org.palpate.imagej.stack.StackVolume;
import org.palpate.imagej.stack.TouchRefusedException;
import org.palpate.loop.LoopEnd;

/**
 * A session from start to end in a thread of its own, so that the command that began it returns and
 * others can work meanwhile, in a macro line by line.
 */
public final class StackSessionRunner {
  private static final String TITLE = "Touch Volume";

  private final StackSession session;
  private final Optional<StackRecording> recording;
  private final SessionWorker worker;

  private StackSessionRunner(StackSession session, Optional<StackRecording> recording) {
    this.session = session;
    this.recording = recording;
    worker = new SessionWorker(this::work, session::askToStop);
  }

  /**
   * Begins a session and waits until force is on.
   *
   * @param recording where one is given, closed with the session or with the refusal
   * @throws TouchRefusedException where it cannot begin
   */
  public static void begin(
      StackVolume volume, TouchOptions options, Optional<StackRecording> recording)
      throws TouchRefusedException {
    boolean begun = false;
    StackSession session = null;
    try {
      CurrentSession.requireNoneRunning();
      session = new StackSession(volume, options, recording.map(StackRecording::recorder));
      StackSessionRunner run = new StackSessionRunner(session, recording);
      CurrentSession.begin(run);
      begun = true;
      run.worker.start();
      session.awaitForce();
    } finally {
      if (!begun) {
        recording.ifPresent(StackRecording::close);
      }
      if (!begun && session != null) {
        session.close();
      }
    }
  }

  StackSession session() {
    return session;
  }

  /** Waits for the end; whether it came. */
  boolean await(long millis) {
    return worker.await(millis);
  }

  private void work() {
    try {
      tell(touch());
    } catch (TouchRefusedException | RuntimeException e) {
      if (!SessionWorker.isProcessEnding()) {
        ErrorDialogs.show(TITLE, e);
      }
    } catch (OutOfMemoryError e) {
      ErrorDialogs.showOutOfMemory(TITLE);
    }
  }

  /** Everything is closed when this returns, and another session may begin. */
  private LoopEnd touch() throws TouchRefusedException {
    try (StackSession touched = session) {
      LoopEnd end = touched.run();
      if (recording.isPresent()) {
        recording.get().finish();
      }
      return end;
    } finally {
      recording.ifPresent(StackRecording::close);
      CurrentSession.end(this);
    }
  }

  private void tell(LoopEnd end) throws TouchRefusedException {
    IJ.showProgress(1);
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: ended after %d frames, zero force sent",
            session.status().frames()));
    if (end.failure() != null) {
      throw new TouchRefusedException("Touching ended by a failure: " + end.failure().getMessage());
    }
  }
}
