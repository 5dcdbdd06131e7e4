package org.palpate.benchmarks.jitter.experiment;

import java.nio.file.Path;
import java.util.List;

/** How a JVM comes by machine code and by its classes. */
public enum JitMode {
  /** As it is shipped. */
  DEFAULT("default"),
  /** The quick compiler alone: less speed, fewer and shorter compilations. */
  C1("c1"),
  /** Graal as the JIT compiler, in the JDKs that have it. */
  GRAAL("graal"),
  /** As shipped, with an archive of the classes that the run loads. */
  CDS("cds"),
  /** JDK 25's ahead-of-time cache: classes, linkage and profiles of an earlier run. */
  AOT("aot");

  /** The first release whose ahead-of-time cache keeps profiles of methods. */
  static final int FIRST_WITH_AOT = 25;

  private final String label;

  JitMode(String label) {
    this.label = label;
  }

  public String label() {
    return label;
  }

  /** Whether an earlier run must leave an archive first. */
  boolean needsTraining() {
    return this == CDS || this == AOT;
  }

  /**
   * Flags of a run that is measured.
   *
   * @param archive what {@link #trainingFlags} left
   */
  List<String> flags(Path archive) {
    return switch (this) {
      case DEFAULT -> List.of();
      case C1 -> List.of("-XX:TieredStopAtLevel=1");
      case GRAAL -> List.of("-XX:+UnlockExperimentalVMOptions", "-XX:+UseJVMCICompiler");
      case CDS -> List.of("-XX:SharedArchiveFile=" + archive);
      case AOT -> List.of("-XX:AOTCache=" + archive);
    };
  }

  /** Flags of the run that leaves the archive when it ends. */
  List<String> trainingFlags(Path archive) {
    return switch (this) {
      case CDS -> List.of("-XX:ArchiveClassesAtExit=" + archive);
      case AOT -> List.of("-XX:AOTCacheOutput=" + archive);
      default -> List.of();
    };
  }
}
