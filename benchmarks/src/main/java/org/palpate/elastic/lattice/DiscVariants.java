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
    ControlLattice lattice = disc.lattice(disc.cube, disc.floor, cellMm);
    float[] load = disc.load(lattice.layout());
    lattice.rotate(new float[load.length]);
    return BeamVariants.compliance(lattice.newSolver(), load);
  }

  /**
   * Returns the depth in a fine lattice below the disc, mm/N, whose sides are displaced as in a
   * coarse lattice of the whole cube.
   *
   * @param edge of the cube, voxels
   * @param radiusMm of the disc
   * @param cellMm the edge of a cell of the coarse lattice
   * @param fineMm the edge of a cell of the fine one
   * @param reachMm from the disc's axis to the sides of the fine lattice, and down to its bottom
   */
  public static double depthInWindow(
      int edge, double radiusMm, double cellMm, double fineMm, int reachMm, double poisson) {
    DiscVariants disc = new DiscVariants(edge, radiusMm, poisson, (int) (4 * cellMm));
    ControlLattice coarse = disc.lattice(disc.cube, disc.floor, cellMm);
    float[] load = disc.load(coarse.layout());
    float[] displacement = new float[load.length];
    coarse.rotate(displacement);
    BeamVariants.solve(coarse.newSolver(), load, displacement);

    BitCube window = disc.window(reachMm);
    BitCube around = disc.cube.copy();
    disc.fillWindow(reachMm, around::clear);
    ControlLattice fine = disc.lattice(window, around, fineMm);
    float[] fineLoad = disc.load(fine.layout());
    float[] inWindow = interpolated(coarse.layout(), displacement, fine.layout());
    fine.rotate(new float[fineLoad.length]);
    float[] residual = new float[fineLoad.length];
    fine.stiffness().multiply(inWindow, residual);
    for (int n = 0; n < residual.length; n++) {
      boolean isFixed = fine.cells().isFixed(n % fine.layout().nodeCount());
      residual[n] = isFixed ? 0 : fineLoad[n] - residual[n];
    }
    BeamVariants.solve(fine.newSolver(), residual, inWindow);
    return Vectors.dot(fineLoad, inWindow);
  }

  private BitCube window(int reachMm) {
    BitCube window = new BitCube(cube.sizeX(), cube.sizeY(), cube.sizeZ());
    fillWindow(reachMm, window::set);
    return window;
  }

  private void fillWindow(int reachMm, BitCube.VoxelSink sink) {
    int middle = margin + edge / 2;
    int top = margin + edge;
    for (int k = top - reachMm; k < top; k++) {
      for (int j = middle - reachMm; j < middle + reachMm; j++) {
        for (int i = middle - reachMm; i < middle + reachMm; i++) {
          sink.take(i, j, k);
        }
      }
    }
  }

  private ControlLattice lattice(BitCube soft, BitCube still, double cellMm) {
    return new ControlLattice(
        new GridMetric(1, 1, 1),
        List.of(new ElasticSegment(soft, material)),
        List.of(still),
        cellMm);
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

  /** Returns a displacement of one lattice at the nodes of another: zero outside of it. */
  private static float[] interpolated(LatticeLayout from, float[] displacement, LatticeLayout to) {
    float[] found = new float[3 * to.nodeCount()];
    double[] at = new double[3];
    for (int node = 0; node < to.nodeCount(); node++) {
      for (int axis = 0; axis < 3; axis++) {
        at[axis] = to.originVoxel(axis) + to.nodeIndex(axis, node) * to.voxelsPerCell(axis);
      }
      for (int axis = 0; axis < 3; axis++) {
        int component = axis;
        float[] sum = new float[1];
        BeamVariants.forCorners(
            from,
            at,
            (corner, weight) ->
                sum[0] += (float) weight * displacement[component * from.nodeCount() + corner]);
        found[axis * to.nodeCount() + node] = sum[0];
      }
    }
    return found;
  }
}
