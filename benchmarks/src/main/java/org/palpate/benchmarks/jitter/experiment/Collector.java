package org.palpate.benchmarks.jitter.experiment;

import java.util.List;
import java.util.Optional;

/** Garbage collectors, and the flags that choose them in each JDK. */
public enum Collector {
  SERIAL("serial", "-XX:+UseSerialGC"),
  PARALLEL("parallel", "-XX:+UseParallelGC"),
  G1("g1", "-XX:+UseG1GC"),
  ZGC("zgc", "-XX:+UseZGC"),
  GENERATIONAL_ZGC("genzgc", "-XX:+UseZGC"),
  SHENANDOAH("shenandoah", "-XX:+UseShenandoahGC"),
  EPSILON("epsilon", "-XX:+UseEpsilonGC");

  private static final int FIRST_WITH_GENERATIONS = 21;
  private static final int GENERATIONS_BY_DEFAULT = 23;
  private static final int LAST_WITHOUT_GENERATIONS = 23;

  private final String label;
  private final String flag;

  Collector(String label, String flag) {
    this.label = label;
    this.flag = flag;
  }

  /** Returns the word for the command line and for tables. */
  public String label() {
    return label;
  }

  /** Returns the flags for a release; empty if no JDK of that release has this collector. */
  Optional<List<String>> flags(int release) {
    return switch (this) {
      case EPSILON -> Optional.of(List.of("-XX:+UnlockExperimentalVMOptions", flag));
      case ZGC -> withoutGenerations(release);
      case GENERATIONAL_ZGC -> withGenerations(release);
      default -> Optional.of(List.of(flag));
    };
  }

  private Optional<List<String>> withoutGenerations(int release) {
    if (release > LAST_WITHOUT_GENERATIONS) {
      return Optional.empty();
    }
    return Optional.of(
        release < GENERATIONS_BY_DEFAULT ? List.of(flag) : List.of(flag, "-XX:-ZGenerational"));
  }

  private Optional<List<String>> withGenerations(int release) {
    if (release < FIRST_WITH_GENERATIONS) {
      return Optional.empty();
    }
    return Optional.of(
        release < GENERATIONS_BY_DEFAULT ? List.of(flag, "-XX:+ZGenerational") : List.of(flag));
  }

  /** Returns the ZGC of a release: the generational one if there is one. */
  static Collector zgcOf(int release) {
    return release < FIRST_WITH_GENERATIONS ? ZGC : GENERATIONAL_ZGC;
  }
}
