package org.palpate.app.output;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.LongBinaryOperator;
import org.palpate.app.process.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.body.Body;
import org.palpate.body.BodyScene;
import org.palpate.body.Mobility;
import org.palpate.edit.EditSchedule;
import org.palpate.edit.VoxelChange;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeWriter;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.BitCube;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/**
 * Reports and exports the segments as they are after a session or a replay has edited them. One
 * thread.
 */
public final class EditedVolume {
  private final SegmentedVolume volume;
  private final CoordinateSystem coordinateSystem;
  private final Optional<Path> export;
  private final List<BitCube> before;

  /**
   * Copies the voxels before any change, if the changes are to be measured.
   *
   * @param export the target, as {@link #checkedExport} returned it
   * @param isCompared whether the changes will be measured, which needs the copy
   */
  public EditedVolume(
      SegmentedVolume volume,
      CoordinateSystem coordinateSystem,
      Optional<Path> export,
      boolean isCompared) {
    this.volume = volume;
    this.coordinateSystem = coordinateSystem;
    this.export = export;
    before =
        isCompared
            ? volume.segments().stream().map(segment -> segment.bits().copy()).toList()
            : List.of();
  }

  /**
   * Returns the target of an export after checking it.
   *
   * @param file the target, or null
   * @param inputs files that must not be replaced
   * @throws VolumeFormatException if there is no format for its name
   * @throws PalpateException exit code 2, if it cannot be written
   */
  public static Optional<Path> checkedExport(Path file, List<Path> inputs)
      throws VolumeFormatException {
    if (file == null) {
      return Optional.empty();
    }
    VolumeWriter.checkName(file);
    return Optional.of(OutputPaths.checked("--export", file, inputs));
  }

  /**
   * Refuses edits that add voxels to bodies that move. Their sample points cover only the voxels
   * that they have at the start.
   *
   * @throws PalpateException exit code 2, if there is such an edit
   */
  public static void requireNothingAddedToMovable(
      BodyScene bodies, EditSchedule edits, Path editsFile) {
    for (VoxelChange change : edits.changes()) {
      Body body = bodies.body(change.segment());
      boolean isNew = change.solid() && !body.bits().get(change.i(), change.j(), change.k());
      if (isNew && body.mobility() == Mobility.MOVABLE) {
        throw PalpateException.wrongUse(
            "a body that moves gains a voxel: " + body.name(),
            editsFile + " frame " + change.frame(),
            "add voxels to bodies that stand still only");
      }
    }
  }

  /** Returns the volume that is missing now, by the name of the segment, mm^3. */
  public Map<String, Object> carvedMm3() {
    return differenceMm3((was, is) -> was & ~is);
  }

  /** Returns the volume that was added, by the name of the segment, mm^3. */
  public Map<String, Object> addedMm3() {
    return differenceMm3((was, is) -> is & ~was);
  }

  /** Returns the volume of the voxels that a function of two bricks finds, mm^3. */
  private Map<String, Object> differenceMm3(LongBinaryOperator found) {
    Map<String, Object> differences = new LinkedHashMap<>();
    for (int n = 0; n < before.size(); n++) {
      Segment segment = volume.segments().get(n);
      Vec3 spacing = volume.grid(n).spacingMm();
      long voxels = count(before.get(n), segment.bits(), found);
      differences.put(segment.name(), voxels * (spacing.x * spacing.y * spacing.z));
    }
    return differences;
  }

  private static long count(BitCube was, BitCube is, LongBinaryOperator found) {
    long voxels = 0;
    for (int z = 0; z < was.bricksZ(); z++) {
      for (int y = 0; y < was.bricksY(); y++) {
        for (int x = 0; x < was.bricksX(); x++) {
          long word = found.applyAsLong(was.brick(x, y, z), is.brick(x, y, z));
          voxels += Long.bitCount(word);
        }
      }
    }
    return voxels;
  }

  /** Writes the segments as they are now if the user asked for it; a failure is reported. */
  public void write(WriteFailures failures, PrintWriter out) {
    write(volume, failures, out);
  }

  /**
   * Writes segments if the user asked for it; a failure is reported.
   *
   * @param left the segments as the session or the replay left them, on one grid
   * @param out receives a line for the file
   */
  public void write(SegmentedVolume left, WriteFailures failures, PrintWriter out) {
    SegmentsAsLabels labels = new SegmentsAsLabels(left, coordinateSystem);
    export.ifPresent(
        target ->
            failures.attempt(
                target,
                () ->
                    out.println(OutputPaths.written(target, VolumeWriter.write(labels, target)))));
  }
}
