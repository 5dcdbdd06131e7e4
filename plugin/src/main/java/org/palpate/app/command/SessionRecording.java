package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.palpate.app.options.RecordOptions;
import org.palpate.app.output.WriteFailures;
import org.palpate.app.process.OutputPaths;
import org.palpate.host.TrajectoryRecording;
import org.palpate.recording.BodyRecorder;
import org.palpate.recording.EditRecorder;
import org.palpate.recording.FieldRecorder;
import org.palpate.recording.SampleRecorder;
import org.palpate.volume.Segment;

/**
 * The recording of a session, if one was asked for. A recording that fails is reported while the
 * session goes on. One thread.
 */
final class SessionRecording implements AutoCloseable {
  private final Optional<TrajectoryRecording> recording;
  private final WriteFailures failures;
  private final boolean hasFields;

  /**
   * Starts a recording.
   *
   * @param options name the file; without one, nothing is recorded
   * @param segments the segments of the scene
   * @throws IOException if the file cannot be created
   */
  SessionRecording(RecordOptions options, List<Segment> segments, WriteFailures failures)
      throws IOException {
    this.failures = failures;
    hasFields = options.hasFields();
    Optional<Path> target = options.file();
    recording =
        target.isPresent()
            ? Optional.of(
                new TrajectoryRecording(
                    target.get(), segments.stream().map(Segment::name).toList()))
            : Optional.empty();
  }

  /**
   * Returns the files that a recording writes or deletes, after checking them.
   *
   * @param target the file; if empty, nothing is recorded
   * @param inputs files that must not be replaced
   * @throws org.palpate.app.process.PalpateException exit code 2, if one cannot be written
   */
  static List<Path> checked(Optional<Path> target, List<Path> inputs) {
    if (target.isEmpty()) {
      return List.of();
    }
    Path samples = OutputPaths.checked("--record", target.get(), inputs);
    return List.of(
        samples,
        OutputPaths.checked("--record", TrajectoryRecording.editsFile(samples), inputs),
        OutputPaths.checked("--record", TrajectoryRecording.posesFile(samples), inputs),
        OutputPaths.checked("--record", TrajectoryRecording.fieldsFile(samples), inputs));
  }

  /** Returns the recorder of the session. */
  Optional<SampleRecorder> recorder() {
    return recording.map(TrajectoryRecording::recorder);
  }

  /** Returns the recorder of the changes of voxels. */
  Optional<EditRecorder> editRecorder() {
    return recording.map(TrajectoryRecording::editRecorder);
  }

  /** Returns the recorder of the poses of bodies. */
  Optional<BodyRecorder> bodyRecorder() {
    return recording.map(TrajectoryRecording::bodyRecorder);
  }

  /** Returns the recorder of updates of elastic segments, if they are to be recorded. */
  Optional<FieldRecorder> fieldRecorder() {
    return recording.filter(any -> hasFields).map(TrajectoryRecording::fieldRecorder);
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
