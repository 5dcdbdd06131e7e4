package org.palpate.elastic.lattice;

import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.BitCube;

/**
 * Presses a rigid disc into a cube of voxels of 1 mm that stands on a floor. The pressure is that
 * of a rigid disc on a half space, F / (2 pi a sqrt(a^2 - r^2)).
 *
 * <p>Reference: Johnson 1985, "Contact Mechanics", section 3.6.
 */
public final class DiscVariants {
  private static final int RINGS = 200;
  private static final int SECTORS = 64;

  private DiscVariants() {}

  /**
   * Returns the depth of the disc, mm/N, in a material of 1 N/mm^2.
   *
   * @param edge of the cube, voxels
   * @param radiusMm of the disc
   * @param cellMm the edge of a cell of the lattice
   */
  public static double depth(int edge, double radiusMm, double cellMm, double poisson) {
    int margin = (int) (4 * cellMm);
    int size = edge + 2 * margin;
    BitCube cube = new BitCube(size, size, size);
    BitCube floor = new BitCube(size, size, size);
    BeamVariants.fill(cube, margin, margin + edge, margin, margin + edge, margin, margin + edge);
    BeamVariants.fill(floor, 0, size, 0, size, 0, margin);
    ControlLattice lattice =
        new ControlLattice(
            new GridMetric(1, 1, 1),
            List.of(new ElasticSegment(cube, new ElasticMaterial(1e6, poisson))),
            List.of(floor),
            cellMm);
    float[] load = new float[3 * lattice.layout().nodeCount()];
    double middle = margin + edge / 2.0;
    for (int ring = 0; ring < RINGS; ring++) {
      // The part of the force within r is 1 - sqrt(1 - r^2/a^2), so each ring carries as much.
      double inside = 1 - (ring + 0.5) / RINGS;
      double r = radiusMm * Math.sqrt(1 - inside * inside);
      for (int sector = 0; sector < SECTORS; sector++) {
        double angle = 2 * Math.PI * (sector + 0.5) / SECTORS;
        double[] at = {
          middle + r * Math.cos(angle), middle + r * Math.sin(angle), (double) margin + edge
        };
        BeamVariants.spread(lattice.layout(), at, -1f / (RINGS * SECTORS), 2, load);
      }
    }
    lattice.rotate(new float[load.length]);
    return BeamVariants.compliance(lattice.newSolver(), load);
  }
}
