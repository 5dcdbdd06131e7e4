package org.palpate.benchmarks;

import java.util.List;
import org.palpate.realtime.RecommendedJvm;

/** The JVM flags with which the launcher starts a session, for the processes of benchmarks. */
public final class SessionJvm {
  private SessionJvm() {}

  /** Returns the flags for a process of the running Java release. */
  public static List<String> flags() {
    return RecommendedJvm.of(Runtime.version().feature()).stream()
        .map(RecommendedJvm.Setting::flag)
        .toList();
  }
}
