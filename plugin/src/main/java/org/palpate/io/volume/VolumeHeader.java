package org.palpate.io.volume;

import java.util.List;
import java.util.Optional;
import org.palpate.volume.VoxelGrid;

/**
 * What a file says of its volume; nothing that names a patient.
 *
 * @param format in words, as in "NRRD, gzip"
 * @param grid sizes, spacing and place; the world is the file's own, see {@code coordinateSystem}
 * @param type the type of number stored
 * @param values what the numbers can be once slope and intercept are applied
 * @param coordinateSystem directions of the world axes in the patient
 * @param labels names and colours, where the file or a table beside it gives some
 * @param notes what a person should know of how the file was understood, a sentence each
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

  /** The same with a table of labels. */
  public VolumeHeader withLabels(LabelTable table) {
    return new VolumeHeader(
        format, grid, type, values, coordinateSystem, Optional.of(table), notes);
  }

  /**
   * The values that the stored type allows, scaled: a bound, not what is there.
   *
   * @param isInteger whether every value is a whole number that fits an {@code int}
   */
  public record ValueRange(double low, double high, boolean isInteger) {
    /** The range of a type whose values are taken as they are. */
    public static ValueRange of(VoxelType type) {
      return new ValueRange(type.low(), type.high(), type.fitsInt());
    }
  }
}
