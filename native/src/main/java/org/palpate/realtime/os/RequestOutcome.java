package org.palpate.realtime.os;

/**
 * What the system answered to one wish.
 *
 * @param wish what was asked for, as a report names it: {@code class}, {@code affinity}, {@code
 *     memory_lock}, {@code timer_slack}
 * @param granted whether the system did it
 * @param detail what was granted, as {@code fifo 40} or {@code cpu 1}; else why it was not, and
 *     what a person can do
 */
public record RequestOutcome(String wish, boolean granted, String detail) {

  static RequestOutcome granted(String wish, String what) {
    return new RequestOutcome(wish, true, what);
  }

  static RequestOutcome refused(String wish, String why) {
    return new RequestOutcome(wish, false, why);
  }

  /** One word. */
  public String word() {
    return granted ? "granted" : "refused";
  }

  @Override
  public String toString() {
    return wish + ": " + word() + (detail.isEmpty() ? "" : " (" + detail + ")");
  }
}
