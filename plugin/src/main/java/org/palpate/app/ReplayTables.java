package org.palpate.app;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.palpate.device.Trajectory;
import org.palpate.geometry.Vec3;
import org.palpate.host.ReplayRun;
import org.palpate.io.FramesCsv;
import org.palpate.io.LegsCsv;
import org.palpate.io.NewFile;
import org.palpate.proxy.InteractionPoint;
import org.palpate.proxy.LegPath;

/** The tables that a replay writes, each only where it was asked for. One thread. */
final class ReplayTables implements ReplayRun.FrameSink, AutoCloseable {
  private final Optional<Path> framesFile;
  private final Optional<Path> legsFile;
  private final List<NewFile> files = new ArrayList<>();
  private Trajectory trajectory = new Trajectory();
  private FramesCsv frames;
  private LegsCsv legs;

  private ReplayTables(Optional<Path> framesFile, Optional<Path> legsFile) {
    this.framesFile = framesFile;
    this.legsFile = legsFile;
  }

  /**
   * Tables whose files were looked at; null for one that is not wanted.
   *
   * @throws PalpateException exit code 2, where one cannot be written, is an input, or is another
   *     output
   */
  static ReplayTables checked(
      Path framesFile, Path legsFile, Optional<Path> report, List<Path> inputs) {
    Optional<Path> frames =
        Optional.ofNullable(framesFile).map(path -> Outputs.checked("--out", path, inputs));
    Optional<Path> legs =
        Optional.ofNullable(legsFile).map(path -> Outputs.checked("--legs", path, inputs));
    List<Path> all = new ArrayList<>();
    frames.ifPresent(all::add);
    legs.ifPresent(all::add);
    report.ifPresent(all::add);
    Outputs.checkDistinct(all);
    return new ReplayTables(frames, legs);
  }

  /** Opens what is wanted, for the frames of a trajectory. */
  void open(Trajectory replayed) throws IOException {
    trajectory = replayed;
    if (framesFile.isPresent()) {
      frames = new FramesCsv(newFile(framesFile.get()).stream());
    }
    if (legsFile.isPresent()) {
      legs = new LegsCsv(newFile(legsFile.get()).stream());
    }
  }

  private NewFile newFile(Path target) throws IOException {
    NewFile file = new NewFile(target);
    files.add(file);
    return file;
  }

  @Override
  public void accept(
      int frame, Vec3 device, Vec3 point, Vec3 forceNewton, InteractionPoint state, boolean freed)
      throws IOException {
    if (frames != null) {
      double timeMs = trajectory.timeMs(frame);
      double pathMm = state.legs.lengthMm();
      frames.add(frame, timeMs, device, point, forceNewton, state.contact, pathMm);
    }
    if (legs != null) {
      addLegs(frame, state, freed);
    }
  }

  private void addLegs(int frame, InteractionPoint state, boolean freed) throws IOException {
    LegPath path = state.legs;
    if (freed) {
      Vec3 place = new Vec3().set(state.position);
      if (path.count() > 0) {
        place.set(path.start(0, 0), path.start(0, 1), path.start(0, 2));
      }
      legs.addFreed(frame, place);
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

  /** Moves every table over its target. */
  void commit() throws IOException {
    for (NewFile file : files) {
      file.commit();
    }
  }

  @Override
  public void close() throws IOException {
    for (NewFile file : files) {
      file.close();
    }
  }
}
