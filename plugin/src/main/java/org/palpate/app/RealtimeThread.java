package org.palpate.app;

import java.util.List;
import org.palpate.interaction.Pacer;
import org.palpate.interaction.ThreadSetup;
import org.palpate.realtime.DeadlineWait;
import org.palpate.realtime.Grant;
import org.palpate.realtime.Realtime;
import org.palpate.realtime.RealtimeWish;
import org.palpate.realtime.WaitKind;

/**
 * Sets up the haptic thread for real time and waits for its deadlines: the system's sleep, then a
 * spin. Both by the haptic thread.
 */
final class RealtimeThread implements ThreadSetup, Pacer {
  private DeadlineWait wait;

  @Override
  public Granted setUp() {
    List<Grant> grants = Realtime.apply(RealtimeWish.usual());
    wait = WaitKind.HYBRID.create();
    return new Granted(
        detail(grants, "class", "normal"),
        detail(grants, "affinity", "any"),
        grants.stream().anyMatch(grant -> grant.wish().equals("memory_lock") && grant.granted()),
        grants.stream().filter(grant -> !grant.granted()).map(Grant::toString).toList());
  }

  private static String detail(List<Grant> grants, String wish, String otherwise) {
    return grants.stream()
        .filter(grant -> grant.wish().equals(wish) && grant.granted())
        .map(Grant::detail)
        .findFirst()
        .orElse(otherwise);
  }

  @Override
  public void awaitUntil(long deadlineNanos) {
    wait.until(deadlineNanos);
  }
}
