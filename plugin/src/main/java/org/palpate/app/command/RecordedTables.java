package org.palpate.app.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;
import org.palpate.app.output.EditedVolume;
import org.palpate.body.BodyScene;
import org.palpate.device.Trajectory;
import org.palpate.edit.EditSchedule;
import org.palpate.host.TrajectoryFile;
import org.palpate.io.table.BodyPose;
import org.palpate.io.table.EditsCsv;
import org.palpate.io.table.PosesCsv;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;
import picocli.CommandLine.Option;

/** The options of a replay that name tables of a recorded session. */
final class RecordedTables {
  @Option(
      names = "--trajectory",
      paramLabel = "T.csv",
      required = true,
      description =
          "Device positions: a header t_ms,x,y,z, then one row for each frame. For a tool also"
              + " qw,qx,qy,qz.")
  private Path trajectoryFile;

  @Option(
      names = "--edits",
      paramLabel = "EDITS.csv",
      description = {
        "Changes of voxels, as touch --record writes them: frame,body,segment,i,j,k,solid."
            + " Each is made before the tool moves in its frame."
      })
  private Path editsFile;

  @Option(
      names = "--poses",
      paramLabel = "POSES.csv",
      description = {
        "Moves bodies: a header frame,body,x,y,z,qw,qx,qy,qz, then a row for each pose that a"
            + " segment approaches from a frame on. The segments that it names can move, the"
            + " others stand still. A point then moves as a rigid tool of one point."
      })
  private Path posesFile;

  @Option(
      names = "--fields",
      paramLabel = "FIELDS.csv",
      description =
          "Updates of elastic segments, as touch --record-fields writes them: the replay then gives"
              + " the bits of that session.")
  private Path fieldsFile;

  @Option(
      names = "--raw-device",
      description = "Handles NaN, infinities and backward times as a live session does.")
  private boolean rawDevice;

  /** Returns all tables that are given. */
  List<Path> files() {
    return Stream.of(trajectoryFile, editsFile, posesFile, fieldsFile)
        .filter(Objects::nonNull)
        .toList();
  }

  /** Whether samples are handled as a live session does, whatever they are. */
  boolean isRaw() {
    return rawDevice;
  }

  /** Reads the trajectory; refuses samples that only {@link #isRaw} takes. */
  Trajectory trajectory() throws IOException {
    return TrajectoryFile.read(trajectoryFile, !rawDevice);
  }

  /** Whether there is a table of changes of voxels. */
  boolean editsVoxels() {
    return editsFile != null;
  }

  /** Reads the changes of voxels; none if there is no table. */
  EditSchedule edits(SegmentedVolume segments) throws IOException {
    return editsVoxels()
        ? EditsCsv.read(editsFile, names(segments), segments.grids())
        : EditSchedule.NONE;
  }

  /**
   * Refuses edits that add voxels to a body that moves.
   *
   * @throws org.palpate.app.process.PalpateException exit code 2
   */
  void requireNothingAddedToMovable(BodyScene bodies, EditSchedule edits) {
    EditedVolume.requireNothingAddedToMovable(bodies, edits, editsFile);
  }

  /** Whether there is a table of poses, so that bodies move. */
  boolean movesBodies() {
    return posesFile != null;
  }

  /** Reads the poses; none if there is no table. */
  List<BodyPose> poses(SegmentedVolume segments) throws IOException {
    return movesBodies() ? PosesCsv.read(posesFile, names(segments)) : List.of();
  }

  private static List<String> names(SegmentedVolume segments) {
    return segments.segments().stream().map(Segment::name).toList();
  }

  /** Returns the table of updates of elastic segments, if it is given. */
  Optional<Path> fieldsFile() {
    return Optional.ofNullable(fieldsFile);
  }
}
