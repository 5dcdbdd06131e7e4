package org.palpate.host;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.palpate.geometry.GridMetric;
import org.palpate.geometry.Vec3;
import org.palpate.io.file.NumberText;
import org.palpate.proxy.ProxySolver;
import org.palpate.proxy.exact.GuardedSolver;
import org.palpate.proxy.reference.BorderVoxels;
import org.palpate.proxy.reference.CollisionOnlySolver;
import org.palpate.proxy.reference.DotSolver;
import org.palpate.proxy.reference.PaperSolver;
import org.palpate.proxy.smooth.SmoothSolver;
import org.palpate.volume.VoxelGrid;

/** The algorithms that move the interaction point. */
public enum SolverKind {
  /** Vlasov et al. 2012; without the guarantee. */
  DOT,
  /** Vlasov et al. 2013 as printed; without the guarantee. */
  PAPER,
  /** Path finding along voxel faces, verified exactly. */
  GUARDED,
  /** Motion along an isosurface of the occupancy field, verified exactly. */
  SMOOTH,
  /** No solver: the interaction point is the device position, and only collisions are found. */
  NONE;

  /** The default of every command and plug-in. */
  public static final SolverKind DEFAULT = SMOOTH;

  /**
   * Parses the name that {@link #toString} returns.
   *
   * @param name the text of a user
   * @return the solver; empty if there is none of this name
   */
  public static Optional<SolverKind> parse(String name) {
    return Arrays.stream(values()).filter(kind -> kind.toString().equals(name)).findFirst();
  }

  /**
   * {@return whether the user may choose the collision method; the other solvers are always exact}
   */
  public boolean choosesCollision() {
    return this == DOT || this == PAPER || this == NONE;
  }

  /** {@return whether no leg of the interaction point can touch a solid} */
  public boolean keepsGuarantee() {
    return !choosesCollision();
  }

  /** {@return the collision method if the user chose none} */
  public CollisionChoice defaultCollision() {
    return this == DOT || this == PAPER ? CollisionChoice.sampled(1) : CollisionChoice.EXACT;
  }

  /** {@return whether the solver looks for border voxels: empty ones beside solid ones} */
  public boolean usesBorderVoxels() {
    return this == DOT || this == PAPER;
  }

  /**
   * Returns a new solver for a scene. It uses the collision method of the settings if it is of
   * their kind, otherwise its own default.
   */
  ProxySolver newSolver(ContactScene scene) {
    ContactSettings settings = scene.settings();
    CollisionChoice collision =
        this == settings.solver() ? settings.collision() : defaultCollision();
    GridMetric metric = scene.metric();
    double maxStepMm = scene.maxStepMm();
    return switch (this) {
      case GUARDED -> new GuardedSolver(metric, maxStepMm);
      case SMOOTH ->
          scene
              .greySource()
              .map(values -> new SmoothSolver(metric, maxStepMm, values))
              .orElseGet(() -> new SmoothSolver(metric, maxStepMm));
      case DOT -> new DotSolver(collision.newCaster(), metric, maxStepMm, newBorder(scene));
      case PAPER -> new PaperSolver(collision.newCaster(), metric, maxStepMm, newBorder(scene));
      case NONE -> new CollisionOnlySolver(collision.newCaster(), metric);
    };
  }

  /**
   * Warns of voxels over which the force may be off, because they are too long for the solver.
   *
   * @param where where the grids come from, as the user knows it
   * @param grids the grids of the voxels
   * @return a line for the user, or empty
   */
  public Optional<String> warning(String where, List<VoxelGrid> grids) {
    double ratio = grids.stream().mapToDouble(grid -> edgeRatio(grid.spacingMm())).max().orElse(1);
    return this == SMOOTH && ratio > SmoothSolver.MAX_EDGE_RATIO
        ? Optional.of(
            "voxels are "
                + NumberText.thousandths(ratio)
                + " times as long as wide: "
                + where
                + ": beyond "
                + NumberText.display(SmoothSolver.MAX_EDGE_RATIO)
                + " times the force of smooth may be off by tens of degrees; choose a series with"
                + " thinner slices")
        : Optional.empty();
  }

  private static double edgeRatio(Vec3 edges) {
    return Math.max(edges.x, Math.max(edges.y, edges.z))
        / Math.min(edges.x, Math.min(edges.y, edges.z));
  }

  private static BorderVoxels newBorder(ContactScene scene) {
    return scene.settings().border().newBorder(scene.grid());
  }

  /** Returns the name on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
