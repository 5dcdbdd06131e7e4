package org.palpate.benchmarks.elastic;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.palpate.benchmarks.rigid.RigidFigure;
import org.palpate.elastic.lattice.BeamVariants;
import org.palpate.elastic.lattice.DiscVariants;

/**
 * Compares elements and lattices with formulas: beams with Timoshenko's, a disc with that of
 * Boussinesq for a rigid disc on a half space. A figure is the deviation in percent.
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
    for (double radius = 8; radius <= 16; radius *= 2) {
      double found = DiscVariants.depth(CUBE, radius, 8, POISSON);
      String condition = String.format(Locale.ROOT, "cells of 8 mm, radius %.0f mm", radius);
      figures.add(deviation(condition, "disc on a half space", found / disc(radius), DISC_TARGET));
    }
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
   * Returns the depth of a rigid disc on a half space of 1 N/mm^2, mm/N, less the displacement that
   * a point force makes in the depth of the floor, which holds the cube.
   *
   * <p>Reference: Johnson 1985, "Contact Mechanics", sections 3.2 and 3.6.
   */
  private static double disc(double radiusMm) {
    double halfSpace = (1 - POISSON * POISSON) / (2 * radiusMm);
    double atFloor = (1 + POISSON) * (3 - 2 * POISSON) / (2 * Math.PI * CUBE);
    return halfSpace - atFloor;
  }
}
