package org.palpate.io.volume;

import java.util.List;
import java.util.Optional;
import org.palpate.volume.VoxelGrid;

/**
 * The header of a volume, without anything that identifies a patient.
 *
 * @param format the format in words, as in "NRRD, gzip"
 * @param grid size, spacing and position; the world is the file's own, see {@code coordinateSystem}
 * @param type the stored type of a voxel
 * @param values the values that are possible after slope and intercept
 * @param coordinateSystem directions of the world axes in the patient
 * @param labels names and colours, if the file or a table beside it has them
 * @param notes assumptions that the user should know, a sentence each
 */
public record VolumeHeader(
    String format,
    VoxelGrid grid,
    VoxelType type,
    ValueRange values,
    CoordinateSystem coordinateSystem,
    Optional<LabelTable> labels,
    List<String> notes) {

  /** Copies the notes. */
  public VolumeHeader {
    notes = List.copyOf(notes);
  }

  /** Returns this header with a label table. */
  public VolumeHeader withLabels(LabelTable table) {
    return new VolumeHeader(
        format, grid, type, values, coordinateSystem, Optional.of(table), notes);
  }

  /**
   * Returns a remark for the report of a written file whose format must name its axes. The remark
   * says which axes were assumed. Empty if this volume names its axes.
   */
  public String axesTakenAs(CoordinateSystem system) {
    return coordinateSystem == CoordinateSystem.UNKNOWN
        ? "; the axes are not named and are taken as " + system
        : "";
  }

  /**
   * The values that the stored type allows after slope and intercept: bounds, not the extremes
   * found in the file.
   *
   * @param isInteger whether every value is an integer that fits an {@code int}
   */
  public record ValueRange(double low, double high, boolean isInteger) {
    /** Returns the range of a type without slope and intercept. */
    public static ValueRange of(VoxelType type) {
      return new ValueRange(type.low(), type.high(), type.fitsInt());
    }
  }
}
