package org.palpate.scene;

import java.util.Locale;

/**
 * Colours deformed surfaces by how they are deformed, in the colours of {@link SurfaceTint}: purple
 * for little, yellow for {@link #most} and more. What is not deformed keeps its own colour.
 *
 * @param measure the value
 * @param most the value of the last colour, positive; mm for a displacement
 */
public record DeformationColour(Measure measure, double most) {
  /** A value of a deformation. */
  public enum Measure {
    /** The distance from the position at rest, mm. */
    DISPLACEMENT(10),

    /**
     * The equivalent strain of von Mises, of Green's strain: for a rod that is stretched without a
     * change of its volume the stretch less 1, if that is small.
     */
    STRAIN(0.3);

    private final double usualMost;

    Measure(double usualMost) {
      this.usualMost = usualMost;
    }

    /** Returns the name as it is written on the command line. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }

    /** Returns the value of the last colour unless another one is wanted. */
    public double usualMost() {
      return usualMost;
    }
  }

  /**
   * Checks the value.
   *
   * @throws IllegalArgumentException if it is not a positive number
   */
  public DeformationColour {
    if (!(most > 0 && most < Double.POSITIVE_INFINITY)) {
      throw new IllegalArgumentException("the value of the last colour must be positive: " + most);
    }
  }
}
