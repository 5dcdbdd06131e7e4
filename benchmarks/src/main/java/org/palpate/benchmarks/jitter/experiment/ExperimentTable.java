package org.palpate.benchmarks.jitter.experiment;

import java.util.List;

/**
 * Cells that answer one question together. A cell may stand in several tables and runs once.
 *
 * @param name one word, as the command line has it
 * @param question what the table tells
 * @param cells in the order of the table
 */
public record ExperimentTable(String name, String question, List<Experiment> cells) {
  public ExperimentTable {
    cells = List.copyOf(cells);
  }
}
