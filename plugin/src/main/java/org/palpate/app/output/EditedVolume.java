package org.palpate.app.output;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.palpate.app.options.OutputPaths;
import org.palpate.app.process.PalpateException;
import org.palpate.geometry.Vec3;
import org.palpate.io.VolumeWriter;
import org.palpate.io.label.SegmentsAsLabels;
import org.palpate.io.volume.CoordinateSystem;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.volume.Segment;
import org.palpate.volume.SegmentedVolume;

/** Reports and exports what a session or a replay left of the segments. One thread. */
public final class EditedVolume {
  private final SegmentedVolume volume;
  private final CoordinateSystem coordinateSystem;
  private final Optional<Path> export;
  private final long[] voxelsBefore;

  /**
   * Counts the voxels before any change.
   *
   * @param export the target, as {@link #checkedExport} returned it
   */
  public EditedVolume(
      SegmentedVolume volume, CoordinateSystem coordinateSystem, Optional<Path> export) {
    this.volume = volume;
    this.coordinateSystem = coordinateSystem;
    this.export = export;
    voxelsBefore =
        volume.segments().stream().mapToLong(segment -> segment.bits().solidCount()).toArray();
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

  /** Returns the removed volume by the name of the segment, mm^3; less than 0 if it has grown. */
  public Map<String, Object> carvedMm3() {
    Vec3 spacing = volume.grid().spacingMm();
    double voxelMm3 = spacing.x * spacing.y * spacing.z;
    Map<String, Object> carved = new LinkedHashMap<>();
    for (int n = 0; n < voxelsBefore.length; n++) {
      Segment segment = volume.segments().get(n);
      carved.put(segment.name(), (voxelsBefore[n] - segment.bits().solidCount()) * voxelMm3);
    }
    return carved;
  }

  /** Writes the segments as they are now if the user asked for it; a failure is reported. */
  public void write(WriteFailures failures) {
    SegmentsAsLabels labels = new SegmentsAsLabels(volume, coordinateSystem);
    export.ifPresent(target -> failures.attempt(target, () -> VolumeWriter.write(labels, target)));
  }
}
