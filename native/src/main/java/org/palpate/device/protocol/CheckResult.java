package org.palpate.device.protocol;

import java.util.Locale;

/**
 * The result of one rule of the protocol.
 *
 * @param outcome whether the device keeps the rule
 * @param rule the rule in words
 * @param found what was found, and what to do if the rule is broken
 */
public record CheckResult(Outcome outcome, String rule, String found) {

  /** Outcomes of a rule. */
  public enum Outcome {
    /** The device keeps the rule. */
    OK,
    /** The capture does not show it, or the device may have a reason. */
    NOTE,
    /** The device breaks the rule. */
    FAILED;

    /** Returns the word that is printed. */
    @Override
    public String toString() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  /** Returns a result that is OK or failed. */
  static CheckResult of(boolean holds, String rule, String found) {
    return new CheckResult(holds ? Outcome.OK : Outcome.FAILED, rule, found);
  }

  /** Returns a result that is OK or a note. */
  static CheckResult note(boolean holds, String rule, String found) {
    return new CheckResult(holds ? Outcome.OK : Outcome.NOTE, rule, found);
  }
}
