package org.palpate.testing;

/**
 * The seed of randomized tests: fixed, or set by {@code -Dpalpate.seed=N}; a failure must print it.
 */
public final class Seeds {
  private static final long DEFAULT = 20130801;

  private Seeds() {}

  /** The seed of this run. */
  public static long seed() {
    String set = System.getProperty("palpate.seed", "");
    return set.isEmpty() || set.startsWith("${") ? DEFAULT : Long.parseLong(set);
  }
}
