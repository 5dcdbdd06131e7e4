package org.palpate.host;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/** What moves the interaction point. */
public enum SolverKind {
  /** Vlasov et al. 2012. */
  DOT,
  /** Vlasov et al. 2013, as printed. */
  PAPER,
  /** The paper's path finding made exact. */
  GUARDED,
  /** Slides on an implicit surface, made exact. */
  SMOOTH,
  /** Nothing: the interaction point is the device, collision alone. */
  NONE;

  /** What every command and plug-in takes unless told otherwise. */
  public static final SolverKind DEFAULT = SMOOTH;

  /** The solver of that name, as {@link #toString} has it; empty where there is none. */
  public static Optional<SolverKind> parse(String name) {
    return Arrays.stream(values()).filter(kind -> kind.toString().equals(name)).findFirst();
  }

  /** Whether the collision method is the user's to choose; the others are always exact. */
  public boolean choosesCollision() {
    return this == DOT || this == PAPER || this == NONE;
  }

  /** The collision method where none was chosen. */
  public CollisionChoice defaultCollision() {
    return this == DOT || this == PAPER ? CollisionChoice.sampled(1) : CollisionChoice.EXACT;
  }

  /** As on the command line. */
  @Override
  public String toString() {
    return name().toLowerCase(Locale.ROOT);
  }
}
