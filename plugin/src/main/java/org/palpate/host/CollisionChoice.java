package org.palpate.host;

import java.util.Optional;
import org.palpate.raycast.ExactRayCaster;
import org.palpate.raycast.GridPlanesRayCaster;
import org.palpate.raycast.RayCaster;
import org.palpate.raycast.SampledRayCaster;

/**
 * Chooses how a path is tested for collisions.
 *
 * @param method the traversal of a straight segment
 * @param stepVoxels distance between samples in grid coordinates for {@link Method#SAMPLED},
 *     otherwise 0
 */
public record CollisionChoice(Method method, double stepVoxels) {
  private static final String SAMPLED_PREFIX = "sampled:";

  /** With a shorter step, a frame would take too many samples. */
  private static final double LEAST_STEP_VOXELS = 0.001;

  private static final double MOST_STEP_VOXELS = 1000;

  /** Traversals of a straight segment; see {@code org.palpate.raycast}. */
  public enum Method {
    /** Samples at equal distances; the paper's method. */
    SAMPLED,
    /** Samples where the segment crosses planes of the grid. */
    GRIDPLANES,
    /** Every closed voxel that the segment meets, decided exactly. */
    EXACT
  }

  /** Decides exactly. */
  public static final CollisionChoice EXACT = new CollisionChoice(Method.EXACT, 0);

  /** Samples where the segment crosses planes of the grid. */
  public static final CollisionChoice GRIDPLANES = new CollisionChoice(Method.GRIDPLANES, 0);

  /**
   * {@return sampling at a distance in grid coordinates}
   *
   * @param stepVoxels the distance between samples, positive
   */
  public static CollisionChoice sampled(double stepVoxels) {
    return new CollisionChoice(Method.SAMPLED, stepVoxels);
  }

  /**
   * {@return the choice that {@code sampled:STEP}, {@code gridplanes} or {@code exact} names; empty
   * if the text is none of them} STEP is a number from 0.001 to 1000.
   *
   * @param text the text of a user
   */
  public static Optional<CollisionChoice> parse(String text) {
    if (text.equals("exact")) {
      return Optional.of(EXACT);
    }
    if (text.equals("gridplanes")) {
      return Optional.of(GRIDPLANES);
    }
    return text.startsWith(SAMPLED_PREFIX)
        ? parseStep(text.substring(SAMPLED_PREFIX.length())).map(CollisionChoice::sampled)
        : Optional.empty();
  }

  private static Optional<Double> parseStep(String text) {
    try {
      double step = Double.parseDouble(text);
      return step >= LEAST_STEP_VOXELS && step <= MOST_STEP_VOXELS
          ? Optional.of(step)
          : Optional.empty();
    } catch (NumberFormatException e) {
      return Optional.empty();
    }
  }

  /** Returns a new ray caster by this method. */
  RayCaster newCaster() {
    return switch (method) {
      case SAMPLED -> new SampledRayCaster(stepVoxels);
      case GRIDPLANES -> new GridPlanesRayCaster();
      case EXACT -> new ExactRayCaster();
    };
  }

  /** Returns the text that {@link #parse} reads. */
  @Override
  public String toString() {
    return switch (method) {
      case SAMPLED -> SAMPLED_PREFIX + stepText();
      case GRIDPLANES -> "gridplanes";
      case EXACT -> "exact";
    };
  }

  private String stepText() {
    long whole = (long) stepVoxels;
    return whole == stepVoxels ? Long.toString(whole) : Double.toString(stepVoxels);
  }
}
