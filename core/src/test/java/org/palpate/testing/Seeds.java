package org.palpate.testing;

/**
 * Gives the seed of randomized tests. It is fixed, or set by {@code -Dpalpate.seed=N}. A failure
 * prints it.
 */
public final class Seeds {
  private static final long DEFAULT = 20130801;

  private Seeds() {}

  /** Returns the seed of this run. */
  public static long seed() {
    String set = System.getProperty("palpate.seed", "");
    return set.isEmpty() || set.startsWith("${") ? DEFAULT : Long.parseLong(set);
  }
}
