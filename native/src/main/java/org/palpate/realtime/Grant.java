package org.palpate.realtime;

/**
 * What the system answered to one wish.
 *
 * @param wish what was asked for, as a report names it: {@code class}, {@code affinity}, {@code
 *     memory_lock}, {@code timer_slack}
 * @param granted whether the system did it
 * @param detail what was granted, as {@code fifo 40} or {@code cpu 1}; else why it was not, and
 *     what a person can do
 */
public record Grant(String wish, boolean granted, String detail) {

  static Grant granted(String wish, String what) {
    return new Grant(wish, true, what);
  }

  static Grant refused(String wish, String why) {
    return new Grant(wish, false, why);
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
