package org.palpate.benchmarks.rigid;

import java.util.List;

/**
 * A measured figure and, if there is one, the value that it must not exceed.
 *
 * @param study the part of the run, such as {@code peg}
 * @param condition scene, tool and clearance
 * @param name the name of the figure
 * @param value the figure
 * @param unit its unit; empty for a count
 * @param target the largest value that meets the target; NaN without a target
 */
public record RigidFigure(
    String study, String condition, String name, double value, String unit, double target) {

  /** Makes a figure without a target. */
  public static RigidFigure of(
      String study, String condition, String name, double value, String unit) {
    return new RigidFigure(study, condition, name, value, unit, Double.NaN);
  }

  /** Whether there is a target. */
  public boolean hasTarget() {
    return !Double.isNaN(target);
  }

  /** Returns {@code met} or {@code missed}, or an empty text without a target. */
  public String verdict() {
    return !hasTarget() ? "" : value <= target ? "met" : "missed";
  }

  /** Returns the cells of its row in {@code rigid.csv}. */
  public List<Object> cells() {
    return List.of(study, condition, name, value, unit, hasTarget() ? target : "", verdict());
  }
}
