package org.palpate.realtime.os;

/**
 * The system's answer to one request.
 *
 * @param request the name of the request in reports: {@code class}, {@code affinity}, {@code
 *     memory_lock}, {@code timer_slack}, {@code vm_threads}
 * @param granted whether the system fulfilled it
 * @param detail the result, such as {@code fifo 40} or {@code cpu 1}; if denied, the reason and the
 *     remedy
 */
public record RequestOutcome(String request, boolean granted, String detail) {

  static RequestOutcome granted(String request, String what) {
    return new RequestOutcome(request, true, what);
  }

  static RequestOutcome denied(String request, String why) {
    return new RequestOutcome(request, false, why);
  }

  /** Returns the word that reports use: {@code granted} or {@code refused}. */
  public String word() {
    return granted ? "granted" : "refused";
  }

  @Override
  public String toString() {
    return request + ": " + word() + (detail.isEmpty() ? "" : " (" + detail + ")");
  }
}
