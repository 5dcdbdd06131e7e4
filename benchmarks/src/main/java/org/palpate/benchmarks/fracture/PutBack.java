package org.palpate.benchmarks.fracture;

import java.util.Locale;
import org.palpate.fracture.Residual;

/**
 * The result for a fragment that a simulated hand was to put back.
 *
 * @param name its name
 * @param residual its motion from where it belongs
 * @param wasTaken whether the hand took hold of it
 * @param hasWay whether it was pulled out of its place before, so that there is a way home
 */
record PutBack(String name, Residual residual, boolean wasTaken, boolean hasWay) {
  /** The largest distance of a fragment that is in place. */
  static final double MOST_MM = 0.5;

  /** The largest angle of a fragment that is in place. */
  static final double MOST_DEGREES = 1;

  /** A fragment that lies farther away was put aside, or was not brought near, mm. */
  private static final double BESIDE_MM = 10;

  /** The place of a fragment, or the cause why it is not in place. */
  enum Outcome {
    IN_PLACE("in place"),
    NOT_TAKEN("not taken"),
    NO_WAY("no way found"),
    ASIDE("did not arrive"),
    BESIDE("left beside its place");

    private final String text;

    Outcome(String text) {
      this.text = text;
    }

    @Override
    public String toString() {
      return text;
    }
  }

  /** Returns the first cause that holds. */
  Outcome outcome() {
    if (residual.distanceMm() <= MOST_MM && residual.angleDegrees() <= MOST_DEGREES) {
      return Outcome.IN_PLACE;
    }
    if (!wasTaken) {
      return Outcome.NOT_TAKEN;
    }
    if (!hasWay) {
      return Outcome.NO_WAY;
    }
    return residual.distanceMm() > BESIDE_MM ? Outcome.ASIDE : Outcome.BESIDE;
  }

  @Override
  public String toString() {
    return String.format(
        Locale.ROOT,
        "%s %s (%.3f mm, %.3f degrees)",
        name,
        outcome(),
        residual.distanceMm(),
        residual.angleDegrees());
  }
}
