package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.palpate.app.output.WriteFailures;
import org.palpate.host.TrajectoryRecording;
import org.palpate.recording.SampleRecorder;

/**
 * The recording of a session, if one was asked for. A recording that fails is reported while the
 * session goes on. One thread.
 */
final class SessionRecording implements AutoCloseable {
  private final Optional<TrajectoryRecording> recording;
  private final WriteFailures failures;

  /**
   * Starts a recording.
   *
   * @param target the file; if empty, nothing is recorded
   * @throws IOException if the file cannot be created
   */
  SessionRecording(Optional<Path> target, WriteFailures failures) throws IOException {
    this.failures = failures;
    recording =
        target.isPresent() ? Optional.of(new TrajectoryRecording(target.get())) : Optional.empty();
  }

  /** Returns the recorder of the session. */
  Optional<SampleRecorder> recorder() {
    return recording.map(TrajectoryRecording::recorder);
  }

  /** Reports a failure so far. Called regularly while the session runs. */
  void check() {
    recording.ifPresent(
        file -> file.failure().ifPresent(cause -> failures.report(file.target(), cause)));
  }

  /** Completes the file after the session's last frame, or reports why it cannot be completed. */
  void finish() {
    recording.ifPresent(file -> failures.attempt(file.target(), file::finish));
  }

  @Override
  public void close() {
    recording.ifPresent(TrajectoryRecording::close);
  }
}
