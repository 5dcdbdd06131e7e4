package org.palpate.benchmarks.elastic;

import java.util.ArrayList;
import java.util.List;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.elastic.WindowVariants;
import org.palpate.elastic.lattice.BeamVariants;
import org.palpate.elastic.lattice.DiscVariants;

/**
 * Compares elements and lattices with formulas: beams with Timoshenko's, a disc with that of
 * Boussinesq for a rigid disc on a half space. It also compares the window around a disc with a
 * whole lattice of cells as short. A figure is the deviation in percent.
 */
final class FormulaStudy {
  private static final String STUDY = "formula";
  private static final String BEAM = "cantilever 96x16x16";
  private static final String PLATE = "plate 96x16x2";
  private static final double LENGTH = 96;
  private static final double WIDTH = 16;
  private static final int CUBE = 96;
  private static final double POISSON = 0.3;
  private static final double PERCENT = 100;
  private static final double BEAM_TARGET = 3;
  private static final double PLATE_TARGET = 20;
  private static final double DISC_TARGET = 10;
  private static final double WINDOW_TARGET = 5;
  private static final String IN_WINDOW = "radius of one cell, in a window";

  /** The edge of a cell below a disc, mm. */
  private static final double CELL = 8;

  private final boolean quick;

  FormulaStudy(boolean quick) {
    this.quick = quick;
  }

  List<RigidFigure> figures() {
    List<RigidFigure> figures = new ArrayList<>();
    for (int through = 1; through <= 4; through *= 2) {
      double found = BeamVariants.ofElements(LENGTH, WIDTH, through, 1, POISSON);
      String condition = "elements alone, cells of " + (int) WIDTH / through + " mm";
      figures.add(deviation(condition, BEAM, found / beam(WIDTH), BEAM_TARGET));
    }
    double layer = BeamVariants.ofElements(LENGTH, WIDTH, 1, 2 / WIDTH, POISSON);
    figures.add(deviation("elements alone, cells of 16 mm", PLATE, layer / beam(2), PLATE_TARGET));
    for (int cell = (int) WIDTH; cell >= (quick ? 8 : 4); cell /= 2) {
      double found = BeamVariants.ofVoxels((int) LENGTH, (int) WIDTH, (int) WIDTH, cell, POISSON);
      figures.add(deviation(inAir(cell), BEAM, found / beam(WIDTH), BEAM_TARGET));
    }
    for (int cell = 8; cell >= (quick ? 4 : 2); cell /= 2) {
      double found = BeamVariants.ofVoxels((int) LENGTH, (int) WIDTH, 2, cell, POISSON);
      figures.add(deviation(inAir(cell), PLATE, found / beam(2), PLATE_TARGET));
    }
    for (int cells = 1; cells <= (quick ? 2 : 4); cells *= 2) {
      figures.add(disc(cells));
    }
    double inWindow = inWindow(CUBE);
    figures.add(window(inWindow));
    figures.add(discInWindow(2 * inWindow(2 * CUBE) - inWindow));
    return figures;
  }

  private static String inAir(int cell) {
    return "in the air of a lattice, cells of " + cell + " mm";
  }

  private static RigidFigure deviation(String condition, String what, double ratio, double target) {
    double percent = PERCENT * Math.abs(ratio - 1);
    return new RigidFigure(STUDY, condition, what + ", off the formula", percent, "%", target);
  }

  /** Returns the deflection of the tip by Timoshenko's formula for 1 N/mm^2, mm/N. */
  private static double beam(double height) {
    double inertia = WIDTH * height * height * height / 12;
    double shear = 1 / (2 * (1 + POISSON));
    double factor = 10 * (1 + POISSON) / (12 + 11 * POISSON);
    return LENGTH * LENGTH * LENGTH / (3 * inertia) + LENGTH / (factor * shear * WIDTH * height);
  }

  /**
   * Compares the depth of a rigid disc with (1 - nu^2) / (2 a) for 1 N/mm^2, mm/N. A cube is not a
   * half space. Its sides and its floor change the depth by an amount that is inversely
   * proportional to its edge. Twice the depth in a cube of twice the edge, less the depth in the
   * cube, leaves that amount out. A contact of one cell has no target, because in sessions a window
   * surrounds it.
   *
   * <p>Reference: Johnson 1985, "Contact Mechanics", section 3.6.
   *
   * @param cells a power of 2, the cells of a radius
   */
  private static RigidFigure disc(int cells) {
    double cellMm = cells < 4 ? CELL : CELL / 2;
    double radiusMm = cells * cellMm;
    double found =
        2 * DiscVariants.depth(2 * CUBE, radiusMm, cellMm, POISSON)
            - DiscVariants.depth(CUBE, radiusMm, cellMm, POISSON);
    double halfSpace = (1 - POISSON * POISSON) / (2 * radiusMm);
    String condition = cells == 1 ? "radius of one cell" : "radius of " + cells + " cells";
    double target = cells == 1 ? Double.NaN : DISC_TARGET;
    return deviation(condition, "disc on a half space", found / halfSpace, target);
  }

  /** Returns the depth of a disc with the radius of one cell, in the window around it, mm/N. */
  private static double inWindow(int cube) {
    return DiscVariants.depthInWindow(cube, CELL, CELL, POISSON, WindowVariants::compliance);
  }

  /** Compares the depth in a window with that in a whole lattice of cells as short. */
  private static RigidFigure window(double found) {
    double whole = DiscVariants.depth(CUBE, CELL, CELL / 2, POISSON);
    return new RigidFigure(
        STUDY,
        IN_WINDOW,
        "disc on a cube, off a whole lattice of short cells",
        PERCENT * Math.abs(found / whole - 1),
        "%",
        WINDOW_TARGET);
  }

  private static RigidFigure discInWindow(double found) {
    double halfSpace = (1 - POISSON * POISSON) / (2 * CELL);
    return deviation(IN_WINDOW, "disc on a half space", found / halfSpace, DISC_TARGET);
  }
}
