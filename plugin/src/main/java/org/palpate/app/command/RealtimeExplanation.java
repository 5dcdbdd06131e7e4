package org.palpate.app.command;

import java.io.PrintWriter;
import java.lang.management.ManagementFactory;
import java.util.Map;
import org.palpate.loop.LoopSettings;
import org.palpate.realtime.RealtimeThread;
import org.palpate.realtime.RecommendedJvm;
import org.palpate.realtime.os.OperatingSystem;
import org.palpate.realtime.os.RequestOutcome;

/** Prints what real time needs, and what this JVM and this system grant. */
final class RealtimeExplanation {
  private final PrintWriter out;

  RealtimeExplanation(PrintWriter out) {
    this.out = out;
  }

  /**
   * Requests real time as a session does, in a thread that ends at once, and prints the outcome.
   */
  void print() {
    int release = Runtime.version().feature();
    out.println("Java " + Runtime.version() + ", " + System.getProperty("java.home"));
    RecommendedJvm.explain(release, ManagementFactory.getRuntimeMXBean().getInputArguments())
        .forEach(line -> out.println("  " + line));
    out.println("The haptic thread");
    try (RealtimeThread realtime = RealtimeThread.recommended(LoopSettings.DEFAULT_PERIOD_NANOS)) {
      Thread thread = new Thread(realtime::setUp, "palpate-explain");
      thread.start();
      join(thread);
      for (RequestOutcome outcome : realtime.outcomes()) {
        out.println("  " + outcome);
      }
      out.println("  wait: " + realtime.waiting());
    }
    Map<String, String> observations = OperatingSystem.kernelSettings();
    if (!observations.isEmpty()) {
      out.println("The system");
      observations.forEach((name, text) -> out.println("  " + name + ": " + text));
    }
    out.println("palpate jitter --quick --out DIR measures the effect on this machine.");
    out.flush();
  }

  private static void join(Thread thread) {
    try {
      thread.join();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
