package org.palpate.elastic.lattice;

import java.util.List;
import java.util.OptionalDouble;
import java.util.function.Function;
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

  private final int edge;
  private final double radiusMm;
  private final ElasticMaterial material;
  private final int margin;
  private final BitCube cube;
  private final BitCube floor;

  /** Makes a cube with a margin of air and floor, voxels. */
  private DiscVariants(int edge, double radiusMm, double poisson, int margin) {
    this.edge = edge;
    this.radiusMm = radiusMm;
    this.margin = margin;
    material = new ElasticMaterial(1e6, poisson);
    int size = edge + 2 * margin;
    cube = new BitCube(size, size, size);
    floor = new BitCube(size, size, size);
    BeamVariants.fill(cube, margin, margin + edge, margin, margin + edge, margin, margin + edge);
    BeamVariants.fill(floor, 0, size, 0, size, 0, margin);
  }

  /**
   * Returns the depth of the disc, mm/N, in a material of 1 N/mm^2.
   *
   * @param edge of the cube, voxels
   * @param radiusMm of the disc
   * @param cellMm the edge of a cell of the lattice
   */
  public static double depth(int edge, double radiusMm, double cellMm, double poisson) {
    DiscVariants disc = new DiscVariants(edge, radiusMm, poisson, (int) (4 * cellMm));
    ControlLattice lattice = disc.lattice(cellMm, OptionalDouble.empty());
    float[] load = disc.load(lattice.layout());
    ConjugateGradients solver = lattice.newSolver();
    solver.rotate(new float[load.length]);
    return BeamVariants.compliance(solver, load);
  }

  /** Solves a window at a place for a load, and returns the depth of the disc, mm/N. */
  public interface InWindow {
    /**
     * Returns the depth.
     *
     * @param displacement that of the whole lattice, mm
     * @param at the place, cells of the lattice
     * @param load returns the load on the nodes of a layout, N
     */
    double depth(
        ControlLattice lattice,
        float[] displacement,
        double[] at,
        Function<LatticeLayout, float[]> load);
  }

  /**
   * Returns the depth in the window that a lattice has around a contact of the disc's radius, mm/N.
   *
   * @param edge of the cube, voxels
   * @param radiusMm of the disc, less than two cells
   * @param cellMm the edge of a cell of the lattice
   */
  public static double depthInWindow(
      int edge, double radiusMm, double cellMm, double poisson, InWindow inWindow) {
    DiscVariants disc = new DiscVariants(edge, radiusMm, poisson, (int) (4 * cellMm));
    ControlLattice lattice = disc.lattice(cellMm, OptionalDouble.of(radiusMm));
    float[] load = disc.load(lattice.layout());
    float[] displacement = new float[load.length];
    ConjugateGradients solver = lattice.newSolver();
    solver.rotate(displacement);
    BeamVariants.solve(solver, load, displacement);
    double middle = disc.margin + edge / 2.0;
    double[] at = {middle, middle, (double) disc.margin + edge};
    for (int axis = 0; axis < 3; axis++) {
      at[axis] = (at[axis] - lattice.layout().originVoxel(axis)) / cellMm;
    }
    return inWindow.depth(lattice, displacement, at, disc::load);
  }

  private ControlLattice lattice(double cellMm, OptionalDouble contactMm) {
    return new ControlLattice(
        new GridMetric(1, 1, 1),
        List.of(new ElasticSegment(cube, material)),
        List.of(floor),
        cellMm,
        contactMm);
  }

  /** Returns the pressure of the disc with a force of 1 N. */
  private float[] load(LatticeLayout layout) {
    float[] load = new float[3 * layout.nodeCount()];
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
        BeamVariants.spread(layout, at, -1f / (RINGS * SECTORS), 2, load);
      }
    }
    return load;
  }
}
