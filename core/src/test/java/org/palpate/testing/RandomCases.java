package org.palpate.testing;

/**
 * Gives the number of cases of randomized tests. {@code -Dpalpate.cases=PART} runs a part of them,
 * for runs that repeat the tests for every mutant of a class.
 */
public final class RandomCases {
  private RandomCases() {}

  /** Returns the cases to run, of the number that a test runs otherwise; at least one. */
  public static int of(int all) {
    double part = Double.parseDouble(System.getProperty("palpate.cases", "1"));
    return (int) Math.max(1, Math.ceil(all * part));
  }
}
