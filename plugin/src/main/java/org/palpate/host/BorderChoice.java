package org.palpate.host;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.PrecalculatedBorderVoxels;
import org.palpate.volume.VoxelGrid;

/** The ways in which the solvers {@code dot} and {@code paper} find empty-space border voxels. */
public enum BorderChoice {
  /** Each query reads the neighbours of the voxel. */
  ON_THE_FLY,
  /** A border voxel is calculated once and kept until the next edit. */
  PRECALCULATED;

  /**
   * Parses the name that {@link #toString} returns.
   *
   * @param name the text of a user
   * @return the choice; empty if there is none of this name
   */
  public static Optional<BorderChoice> parse(String name) {
    return Arrays.stream(values()).filter(choice -> choice.toString().equals(name)).findFirst();
  }

  /** Returns border voxels of a scene over a grid, which are found in this way. */
  BorderVoxels newBorder(VoxelGrid grid) {
    return switch (this) {
      case ON_THE_FLY -> BorderVoxels.onTheFly();
      case PRECALCULATED -> new PrecalculatedBorderVoxels(grid.sizeX(), grid.sizeY(), grid.sizeZ());
    };
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }
}
