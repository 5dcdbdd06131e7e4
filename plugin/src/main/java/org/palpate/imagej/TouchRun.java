package org.palpate.imagej;

import ij.IJ;
import java.util.Locale;
import java.util.Optional;
import org.palpate.host.SessionWorker;
import org.palpate.interaction.LoopEnd;

/**
 * A session from start to end in a thread of its own, so that the command that began it returns and
 * others can work meanwhile, in a macro line by line.
 */
final class TouchRun {
  private static final String TITLE = "Touch Volume";

  private final StackSession session;
  private final Optional<StackRecording> recording;
  private final SessionWorker worker;

  private TouchRun(StackSession session, Optional<StackRecording> recording) {
    this.session = session;
    this.recording = recording;
    worker = new SessionWorker(this::work, session::askToStop);
  }

  /**
   * Begins a session and waits until force is on.
   *
   * @param recording where one is given, closed with the session or with the refusal
   * @throws StackRefused where it cannot begin
   */
  static void begin(StackVolume volume, TouchOptions options, Optional<StackRecording> recording)
      throws StackRefused {
    boolean begun = false;
    StackSession session = null;
    try {
      Sessions.refuseSecond();
      session = new StackSession(volume, options, recording.map(StackRecording::recorder));
      TouchRun run = new TouchRun(session, recording);
      Sessions.begin(run);
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
    } catch (StackRefused | RuntimeException e) {
      if (!SessionWorker.isProcessEnding()) {
        PlainErrors.show(TITLE, e);
      }
    } catch (OutOfMemoryError e) {
      PlainErrors.showOutOfMemory(TITLE);
    }
  }

  /** Everything is closed when this returns, and another session may begin. */
  private LoopEnd touch() throws StackRefused {
    try (StackSession touched = session) {
      LoopEnd end = touched.run();
      if (recording.isPresent()) {
        recording.get().finish();
      }
      return end;
    } finally {
      recording.ifPresent(StackRecording::close);
      Sessions.end(this);
    }
  }

  private void tell(LoopEnd end) throws StackRefused {
    IJ.showProgress(1);
    IJ.showStatus(
        String.format(
            Locale.ROOT,
            "Palpate: ended after %d frames, zero force sent",
            session.status().frames()));
    if (end.failure() != null) {
      throw new StackRefused("Touching ended by a failure: " + end.failure().getMessage());
    }
  }
}
