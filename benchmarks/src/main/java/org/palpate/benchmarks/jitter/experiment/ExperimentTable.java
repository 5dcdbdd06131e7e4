package org.palpate.benchmarks.jitter.experiment;

import java.util.List;

/**
 * Experiments that answer one question together. An experiment may be in several tables; it runs
 * once.
 *
 * @param name one word, as on the command line
 * @param question the question that the table answers
 * @param experiments the experiments, in the order of the table
 */
public record ExperimentTable(String name, String question, List<Experiment> experiments) {
  /** Copies the list. */
  public ExperimentTable {
    experiments = List.copyOf(experiments);
  }
}
