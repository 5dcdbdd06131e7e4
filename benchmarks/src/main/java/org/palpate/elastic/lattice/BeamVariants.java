package org.palpate.elastic.lattice;

import java.util.Arrays;
import java.util.List;
import org.palpate.geometry.GridMetric;
import org.palpate.volume.BitCube;

/** Bends clamped beams, made of elements alone or of voxels in the air of a lattice. */
public final class BeamVariants {
  private static final double RESIDUAL = 1e-5;
  private static final int MOST_STEPS = 4000;
  private static final double PRECISE_NEWTON = 1e-3;

  private BeamVariants() {}

  /**
   * Returns the deflection of the tip of a beam of elements of 1 N/mm^2 without air, mm/N.
   *
   * @param lengthMm along x; clamped where x is 0
   * @param thickMm the width and the height
   * @param through the number of elements through the height
   * @param part the part of the height of each element that is filled
   */
  public static double ofElements(
      double lengthMm, double thickMm, int through, double part, double poisson) {
    double edge = thickMm / through;
    int along = (int) Math.round(lengthMm / edge);
    LatticeLayout layout =
        new LatticeLayout(
            new int[3],
            new int[] {1, 1, 1},
            new int[] {along, through, through},
            new double[] {edge, edge, edge});
    boolean[] fixed = new boolean[layout.nodeCount()];
    for (int node = 0; node < fixed.length; node++) {
      fixed[node] = layout.nodeIndex(0, node) == 0;
    }
    StiffnessOperator stiffness = new StiffnessOperator(new ActiveCells(layout, fixed), poisson);
    Arrays.fill(stiffness.modulus(), (float) part);
    Arrays.fill(stiffness.moment(2), (float) (part * part));
    stiffness.changed();
    MultigridPreconditioner multigrid = new MultigridPreconditioner(stiffness, poisson);
    float[] load = new float[3 * layout.nodeCount()];
    for (int k = 0; k <= through; k++) {
      for (int j = 0; j <= through; j++) {
        float weight = (j % through == 0 ? 0.5f : 1) * (k % through == 0 ? 0.5f : 1);
        load[2 * layout.nodeCount() + layout.node(along, j, k)] = weight;
      }
    }
    multigrid.refresh(new float[load.length]);
    return compliance(new ConjugateGradients(stiffness, multigrid), load);
  }

  /**
   * Returns the deflection of the tip of a beam of voxels of 1 mm and 1 N/mm^2, which a block holds
   * at one end, in the air of its lattice, mm/N.
   *
   * @param length voxels along x
   * @param width voxels along y
   * @param height voxels along z
   * @param edgeMm the edge of a cell
   */
  public static double ofVoxels(int length, int width, int height, double edgeMm, double poisson) {
    int margin = (int) (4 * edgeMm);
    BitCube beam = new BitCube(length + 2 * margin, width + 2 * margin, height + 2 * margin);
    BitCube holder = new BitCube(beam.sizeX(), beam.sizeY(), beam.sizeZ());
    fill(beam, margin, margin + length, margin, margin + width, margin, margin + height);
    fill(holder, 0, margin, 0, beam.sizeY(), 0, beam.sizeZ());
    ElasticMaterial material = new ElasticMaterial(1e6, poisson);
    ControlLattice lattice =
        new ControlLattice(
            new GridMetric(1, 1, 1),
            List.of(new ElasticSegment(beam, material)),
            List.of(holder),
            edgeMm);
    float[] load = new float[3 * lattice.layout().nodeCount()];
    loadTip(lattice.layout(), margin + length, margin, margin + width, margin, height, load);
    ConjugateGradients solver = lattice.newSolver();
    solver.rotate(new float[load.length]);
    return compliance(solver, load);
  }

  static void fill(BitCube bits, int x0, int x1, int y0, int y1, int z0, int z1) {
    for (int k = z0; k < z1; k++) {
      for (int j = y0; j < y1; j++) {
        for (int i = x0; i < x1; i++) {
          bits.set(i, j, k);
        }
      }
    }
  }

  /** Spreads a unit force along z over the voxels of the end face. */
  private static void loadTip(
      LatticeLayout layout, int x, int y0, int y1, int z0, int height, float[] dest) {
    for (int k = z0; k < z0 + height; k++) {
      for (int j = y0; j < y1; j++) {
        double[] at = {x, j + 0.5, k + 0.5};
        spread(layout, at, 1f / ((y1 - y0) * height), 2, dest);
      }
    }
  }

  /** Receives a node and its weight. */
  @FunctionalInterface
  interface WeightedNode {
    /** Receives a node and its weight. */
    void take(int node, double weight);
  }

  /** Spreads a force at a point in grid coordinates over the corners of its cell. */
  static void spread(LatticeLayout layout, double[] at, float newton, int axis, float[] dest) {
    forCorners(
        layout,
        at,
        (node, weight) -> dest[axis * layout.nodeCount() + node] += (float) (newton * weight));
  }

  /** Hands out the corners of the cell of a point in grid coordinates with trilinear weights. */
  static void forCorners(LatticeLayout layout, double[] at, WeightedNode sink) {
    int[] cell = new int[3];
    double[] into = new double[3];
    for (int n = 0; n < 3; n++) {
      double cells = (at[n] - layout.originVoxel(n)) / layout.voxelsPerCell(n);
      if (!(cells >= 0 && cells <= layout.cells(n))) {
        return;
      }
      cell[n] = (int) cells;
      into[n] = cells - cell[n];
    }
    int first = layout.node(cell[0], cell[1], cell[2]);
    for (int corner = 0; corner < LatticeLayout.CORNERS; corner++) {
      double weight = 1;
      for (int n = 0; n < 3; n++) {
        weight *= (corner >> n & 1) == 1 ? into[n] : 1 - into[n];
      }
      if (weight > 0) {
        sink.take(first + layout.cornerOffset(corner), weight);
      }
    }
  }

  /** Adds the solution for a load or a residual to a displacement. */
  static void solve(ConjugateGradients solver, float[] load, float[] displacement) {
    double goal = Math.max(PRECISE_NEWTON * RESIDUAL, RESIDUAL * Vectors.norm(load));
    solver.solve(load.clone(), displacement, goal, MOST_STEPS);
  }

  /** Returns the displacement along a load, weighted by it, over the load's size squared. */
  static double compliance(ConjugateGradients solver, float[] load) {
    double sum = 0;
    for (float newton : load) {
      sum += newton;
    }
    float[] displacement = new float[load.length];
    solve(solver, load, displacement);
    return Vectors.dot(load, displacement) / (sum * sum);
  }
}
