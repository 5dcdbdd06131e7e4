package org.palpate.app.output;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.host.ReplayRun;
import org.palpate.host.ToolScene;
import org.palpate.io.file.AtomicFile;
import org.palpate.io.table.FramesCsvWriter;
import org.palpate.io.table.LegsCsvWriter;
import org.palpate.io.table.ToolFramesCsvWriter;
import org.palpate.io.table.ToolLegsCsvWriter;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;

/** The tables that a replay writes, each only if it was asked for. One thread. */
public final class ReplayTables implements ReplayRun.FrameSink, AutoCloseable {
  private final Optional<Path> framesFile;
  private final Optional<Path> legsFile;
  private final Map<Path, AtomicFile> files = new LinkedHashMap<>();
  private final WriteFailures failures;
  private Trajectory trajectory = new Trajectory();
  private FramesCsvWriter frames;
  private LegsCsvWriter legs;

  private ReplayTables(Optional<Path> framesFile, Optional<Path> legsFile, WriteFailures failures) {
    this.failures = failures;
    this.framesFile = framesFile;
    this.legsFile = legsFile;
  }

  /**
   * Returns the tables after checking their files.
   *
   * @param framesFile target of the frames, or null
   * @param legsFile target of the legs, or null
   * @param failures receives a table that cannot be written; the others go on
   * @throws PalpateException exit code 2, if a file cannot be written, is an input or is another
   *     output
   */
  public static ReplayTables checked(
      Path framesFile,
      Path legsFile,
      Optional<Path> report,
      List<Path> inputs,
      WriteFailures failures) {
    Optional<Path> frames =
        Optional.ofNullable(framesFile).map(path -> OutputPaths.checked("--out", path, inputs));
    Optional<Path> legs =
        Optional.ofNullable(legsFile).map(path -> OutputPaths.checked("--legs", path, inputs));
    List<Path> all = new ArrayList<>();
    frames.ifPresent(all::add);
    legs.ifPresent(all::add);
    report.ifPresent(all::add);
    OutputPaths.checkDistinct(all);
    return new ReplayTables(frames, legs, failures);
  }

  /** Opens the tables for the frames of a trajectory. */
  public void open(Trajectory replayed) throws IOException {
    trajectory = replayed;
    if (framesFile.isPresent()) {
      frames = new FramesCsvWriter(newFile(framesFile.get()).stream());
    }
    if (legsFile.isPresent()) {
      legs = new LegsCsvWriter(newFile(legsFile.get()).stream());
    }
  }

  /** Opens the tables of a rigid tool for the frames of a trajectory. */
  public ToolTables openForTool(
      Trajectory replayed, ToolScene scene, ToolTables.LegSelection selection) throws IOException {
    Optional<ToolFramesCsvWriter> toolFrames = Optional.empty();
    if (framesFile.isPresent()) {
      toolFrames = Optional.of(new ToolFramesCsvWriter(newFile(framesFile.get()).stream()));
    }
    Optional<ToolLegsCsvWriter> toolLegs = Optional.empty();
    if (legsFile.isPresent()) {
      toolLegs = Optional.of(new ToolLegsCsvWriter(newFile(legsFile.get()).stream()));
    }
    return new ToolTables(replayed, scene, selection, toolFrames, toolLegs, this);
  }

  private AtomicFile newFile(Path target) throws IOException {
    AtomicFile file = new AtomicFile(target);
    files.put(target, file);
    return file;
  }

  @Override
  public void accept(
      int frame, Vec3 device, Vec3 point, Vec3 forceNewton, InteractionPoint state, boolean freed) {
    if (frames != null) {
      double timeMs = trajectory.timeMs(frame);
      double pathMm = state.legs.lengthMm();
      toFrames(() -> frames.add(frame, timeMs, device, point, forceNewton, state.contact, pathMm));
    }
    if (legs != null) {
      toLegs(() -> addLegs(frame, state, freed));
    }
  }

  /** Writes to the table of frames, unless it failed. */
  void toFrames(WriteFailures.Writing rows) {
    framesFile.ifPresent(target -> failures.attempt(target, rows));
  }

  /** Writes to the table of legs, unless it failed. */
  void toLegs(WriteFailures.Writing rows) {
    legsFile.ifPresent(target -> failures.attempt(target, rows));
  }

  private void addLegs(int frame, InteractionPoint state, boolean freed) throws IOException {
    LegPath path = state.legs;
    if (freed) {
      Vec3 start = new Vec3().set(state.position);
      if (path.count() > 0) {
        start.set(path.start(0, 0), path.start(0, 1), path.start(0, 2));
      }
      legs.addRelease(frame, start);
    }
    for (int leg = 0; leg < path.count(); leg++) {
      legs.add(
          frame,
          leg,
          path.start(leg, 0),
          path.start(leg, 1),
          path.start(leg, 2),
          path.end(leg, 0),
          path.end(leg, 1),
          path.end(leg, 2));
    }
  }

  /** Moves every finished table over its target. */
  public void commit() {
    files.forEach((target, file) -> failures.attempt(target, file::commit));
  }

  @Override
  public void close() {
    files.forEach((target, file) -> failures.attempt(target, file::close));
  }
}
