package org.palpate.app.options;

import java.util.List;
import java.util.Optional;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.VoxelGrid;

/** Notes voxels that are too long for the solver {@code smooth}. */
final class LongVoxels {
  private LongVoxels() {}

  /**
   * Returns a line for the user if voxels of some grid are too long.
   *
   * @param name where the grids come from, as the user knows it
   */
  static Optional<String> note(String name, List<VoxelGrid> grids) {
    double ratio = grids.stream().mapToDouble(grid -> ratio(grid.spacingMm())).max().orElse(1);
    return ratio > SmoothSolver.MAX_EDGE_RATIO
        ? Optional.of(
            "palpate: voxels are "
                + NumberText.thousandths(ratio)
                + " times as long as wide: "
                + name
                + ": beyond "
                + NumberText.display(SmoothSolver.MAX_EDGE_RATIO)
                + " times the force of smooth may be off by tens of degrees; choose a series with"
                + " thinner slices")
        : Optional.empty();
  }

  private static double ratio(Vec3 edges) {
    return Math.max(edges.x, Math.max(edges.y, edges.z))
        / Math.min(edges.x, Math.min(edges.y, edges.z));
  }
}
