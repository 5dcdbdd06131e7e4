package org.palpate.app.options;

import java.util.Optional;
import org.palpate.io.resample.ResampledReader;
import org.palpate.io.resample.Resampling;
import org.palpate.io.volume.VolumeFormatException;
import org.palpate.io.volume.VolumeReader;
import picocli.CommandLine.Option;

/** The options that give an exported volume another grid. */
public final class ReshapeOptions {
  @Option(
      names = "--crop",
      paramLabel = "I..I,J..J,K..K",
      description = "Exports the voxels of a box alone: first..last along x, y and z, from 0.")
  private String crop;

  @Option(
      names = "--mirror",
      paramLabel = "X,Y,Z,NX,NY,NZ",
      description = {
        "Exports the volume as a plane mirrors it, to aim at a healthy side: a point of the plane"
            + " and its normal, world mm."
      })
  private String mirror;

  /** Whether an option was given. */
  public boolean isWanted() {
    return crop != null || mirror != null;
  }

  /**
   * Checks the options against the grid of a volume, without reading its values.
   *
   * @param spacing the voxels that {@code --resample} asks for, if any
   * @throws VolumeFormatException if an option is not understood or leaves the volume
   */
  public void check(VolumeReader reader, Optional<String> spacing) throws VolumeFormatException {
    applyTo(reader, spacing, true);
  }

  /**
   * Returns a reader of the cropped, then resampled, then mirrored volume.
   *
   * @param spacing the voxels that {@code --resample} asks for, if any
   * @param isLabels whether the values are labels, which must not be interpolated
   * @throws VolumeFormatException if an option is not understood
   */
  public VolumeReader applyTo(VolumeReader reader, Optional<String> spacing, boolean isLabels)
      throws VolumeFormatException {
    VolumeReader shaped = reader;
    if (crop != null) {
      Resampling box = Resampling.crop(shaped.header().grid(), crop);
      shaped = new ResampledReader(shaped, box, isLabels);
    }
    if (spacing.isPresent()) {
      Resampling voxels = Resampling.spacing(shaped.header().grid(), spacing.get());
      shaped = new ResampledReader(shaped, voxels, isLabels);
    }
    if (mirror != null) {
      Resampling plane = Resampling.mirror(shaped.header().grid(), mirror);
      shaped = new ResampledReader(shaped, plane, isLabels);
    }
    return shaped;
  }
}
