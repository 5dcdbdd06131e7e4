package org.palpate.benchmarks.jitter.experiment;

import java.nio.file.Path;
import java.util.List;

/** Sources of a JVM's machine code and classes. */
public enum JitMode {
  /** The defaults of the JDK. */
  DEFAULT("default"),
  /** The C1 compiler alone: slower code, fewer and shorter compilations. */
  C1("c1"),
  /** Graal as the JIT compiler, if the JDK has it. */
  GRAAL("graal"),
  /** The defaults, with an archive of the classes that the run loads. */
  CDS("cds"),
  /** The ahead-of-time cache of JDK 25: classes, linkage and profiles of an earlier run. */
  AOT("aot");

  /** The first release whose ahead-of-time cache contains method profiles. */
  static final int FIRST_WITH_AOT = 25;

  private final String label;

  JitMode(String label) {
    this.label = label;
  }

  /** Returns the word for a table. */
  public String label() {
    return label;
  }

  /** Whether an earlier run must make an archive. */
  boolean needsTraining() {
    return this == CDS || this == AOT;
  }

  /**
   * Returns the flags of the measured run.
   *
   * @param archive the archive made with {@link #trainingFlags}
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

  /** Returns the flags of the run that makes the archive at its end. */
  List<String> trainingFlags(Path archive) {
    return switch (this) {
      case CDS -> List.of("-XX:ArchiveClassesAtExit=" + archive);
      case AOT -> List.of("-XX:AOTCacheOutput=" + archive);
      default -> List.of();
    };
  }
}
